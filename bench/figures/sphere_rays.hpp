#pragma once
/// \file
/// Many rays against one sphere, made from a family's cases, as arrays to be timed.

#include <array>
#include <cmath>
#include <optional>
#include <rayproof/sphere.hpp>
#include <rayproof/transform.hpp>
#include <vector>

#include "case/case.hpp"

namespace rayproof::report {

/// A batch has one sphere and one transform, and every case has its own. So each case is moved and scaled in
/// its sphere's own space until its sphere is the first case's, and goes back into the world by the first
/// case's transform: the ray keeps how it lies to the sphere. Where that over- or underflows, the first
/// case's ray stands in.
template <class T>
struct SphereRays {
  std::array<std::vector<T>, 6> column;  ///< origin and direction
  std::array<std::vector<T>, 3> unit;    ///< direction of length 1
  std::vector<T> t;                      ///< the answers
  Sphere<T> sphere{};
  std::optional<ObjectSpace<T>> space{};

  explicit SphereRays(const std::vector<Case>& cases) : t(cases.size()) {
    const auto& first = std::get<RayQuestion>(cases.front().question);
    sphere = convert<T>(std::get<Sphere<double>>(first.shape));
    if (first.transform) space = object_space(glm::mat<4, 4, T>(*first.transform));
    for (const Case& one : cases) {
      const Ray<T> ray = convert<T>(carried_over(std::get<RayQuestion>(one.question), first));
      push_back(is_usable(ray) ? ray : convert<T>(first.ray));
    }
  }

  [[nodiscard]] Ray<T> ray(std::size_t i) const {
    return {{column[0][i], column[1][i], column[2][i]}, {column[3][i], column[4][i], column[5][i]}};
  }

 private:
  static bool is_usable(const Ray<T>& ray) {
    const T size = dot(ray.origin, ray.origin) + dot(ray.direction, ray.direction);
    return std::isfinite(size) && dot(ray.direction, ray.direction) > 0;
  }

  /// The ray of `one`, aimed at the sphere of `other` as it was at its own.
  static Ray<double> carried_over(const RayQuestion& one, const RayQuestion& other) {
    const auto& from = std::get<Sphere<double>>(one.shape);
    const auto& to = std::get<Sphere<double>>(other.shape);
    const Ray<double> own = one.transform ? to_object(object_space(*one.transform), one.ray) : one.ray;
    const double scale = from.radius > 0 && to.radius > 0 ? to.radius / from.radius : 1;
    Ray<double> ray{to.center + scale * (own.origin - from.center), scale * own.direction};
    if (other.transform) {
      ray.origin = glm::dvec3(*other.transform * glm::dvec4(ray.origin, 1));
      ray.direction = glm::dvec3(*other.transform * glm::dvec4(ray.direction, 0));
    }
    return ray;
  }

  void push_back(const Ray<T>& ray) {
    const vec3<T> unit_direction = ray.direction / std::sqrt(dot(ray.direction, ray.direction));
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      column[i].push_back(ray.origin[axis]);
      column[i + 3].push_back(ray.direction[axis]);
      unit[i].push_back(unit_direction[axis]);
    }
  }
};

}  // namespace rayproof::report
