#pragma once
/// \file
/// What the answers of all shapes have in common: an exact t, a Quotient or an ExactRoot, against the ray's
/// interval, as a point, and as a place where a normal stands.

#include <array>
#include <cmath>

#include "oracle/geometry/scene.hpp"
#include "oracle/numbers/rounding.hpp"

namespace rayproof::oracle {

/// Whether an exact t lies in the ray's closed interval.
template <class Number>
[[nodiscard]] bool is_in_interval(const Number& t, const Ray<double>& ray) {
  const bool above = std::isinf(ray.t_min) || t.compare(Ring(ray.t_min)) >= 0;
  return above && (std::isinf(ray.t_max) || t.compare(Ring(ray.t_max)) <= 0);
}

/// o + d·t at the exact t, each coordinate rounded once.
template <class Number>
[[nodiscard]] glm::dvec3 exact_point(const Ray<double>& ray, const Number& t, Precision precision) {
  glm::dvec3 point{};
  for (int axis = 0; axis < 3; ++axis) {
    point[axis] =
        round_correctly(t.affine_image(Ring(ray.origin[axis]), Ring(ray.direction[axis])), precision);
  }
  return point;
}

/// The unit vector along n, each component within one ulp of 1.
[[nodiscard]] glm::dvec3 unit_vector(const std::array<Scaled, 3>& n, Precision precision);
[[nodiscard]] glm::dvec3 unit_vector(const Vector<Ring>& n, Precision precision);

/// The unit vector along offset + t·slope at the exact t.
template <class Number>
[[nodiscard]] glm::dvec3 unit_vector(const Vector<Ring>& offset, const Vector<Ring>& slope, const Number& t,
                                     Precision precision) {
  return unit_vector(
      {t.affine_image(offset.x, slope.x).estimate(), t.affine_image(offset.y, slope.y).estimate(),
       t.affine_image(offset.z, slope.z).estimate()},
      precision);
}

/// A normal of the object as the world has it: by the inverse transpose, up to a positive factor.
[[nodiscard]] Vector<Ring> normal_to_world(const ObjectRay<Ring>& ray, const Vector<Ring>& normal);

}  // namespace rayproof::oracle
