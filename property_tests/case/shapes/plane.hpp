#pragma once
/// \file
/// The three forms of a plane in the case format. Each is a shape of its own there; the library has one Plane
/// that knows its form.

#include <rayproof/plane.hpp>

#include "case/independent.hpp"
#include "case/shape_format.hpp"

namespace rayproof {

/// normal·q + d = 0.
struct ImplicitPlane {
  glm::dvec3 normal{};
  double d{};
};

/// normal·(q - point) = 0.
struct PointNormalPlane {
  glm::dvec3 point{};
  glm::dvec3 normal{};
};

/// All point + a·u + b·v.
struct ParametricPlane {
  glm::dvec3 point{};
  glm::dvec3 u{};
  glm::dvec3 v{};
};

[[nodiscard]] inline Plane<double> library_shape(const ImplicitPlane& plane) {
  return {.form = PlaneForm::implicit, .point{}, .normal = plane.normal, .d = plane.d, .u{}, .v{}};
}
[[nodiscard]] inline Plane<double> library_shape(const PointNormalPlane& plane) {
  return {PlaneForm::point_normal, plane.point, plane.normal, {}, {}, {}};
}
[[nodiscard]] inline Plane<double> library_shape(const ParametricPlane& plane) {
  return {PlaneForm::parametric, plane.point, {}, {}, plane.u, plane.v};
}

/// What all forms have in common.
struct PlaneFormat {
  static constexpr const char* type = "plane";

  static void validate(const auto& plane) {
    if (plane.normal == glm::dvec3(0)) throw Refusal("normal", "the plane's normal must not be zero");
  }
};

template <>
struct ShapeFormat<ImplicitPlane> : PlaneFormat {
  static void fields(auto& plane, auto&& visit) {
    visit("normal", plane.normal);
    visit("d", plane.d);
  }
};

template <>
struct ShapeFormat<PointNormalPlane> : PlaneFormat {
  static void fields(auto& plane, auto&& visit) {
    visit("point", plane.point);
    visit("normal", plane.normal);
  }
};

template <>
struct ShapeFormat<ParametricPlane> : PlaneFormat {
  static void fields(auto& plane, auto&& visit) {
    visit("point", plane.point);
    visit("u", plane.u);
    visit("v", plane.v);
  }

  static void validate(const ParametricPlane& plane) {
    if (!are_independent(plane.u, plane.v)) throw Refusal("u", "the plane's u and v must not be dependent");
  }
};

}  // namespace rayproof
