#pragma once
/// \file
/// On which side of a triangle's edges a line passes, exactly.

#include "oracle/geometry/flat.hpp"

namespace rayproof::oracle {

/// The triangle's plane, with (b-a)×(c-a) as its normal; a zero normal where the area is zero.
[[nodiscard]] inline FlatEquation plane_of(const Triangle<double>& triangle) {
  const auto a = Vector<Ring>::from(triangle.a);
  const Vector<Ring> normal = cross(Vector<Ring>::from(triangle.b) - a, Vector<Ring>::from(triangle.c) - a);
  return {normal, dot(normal, a)};
}

[[nodiscard]] inline bool is_zero(const Vector<Ring>& v) {
  return sign(v.x) == 0 && sign(v.y) == 0 && sign(v.z) == 0;
}

/// The signed volumes that the ray's direction spans with each edge as seen from the origin. Over their sum
/// they are the barycentric coordinates of the point in which the line meets the triangle's plane.
struct TriangleVolumes {
  Ring a, b, c;

  TriangleVolumes(const ObjectRay<Ring>& ray, const Triangle<double>& triangle) {
    const auto seen = [&](const glm::dvec3& vertex) {
      return ray.scale * Vector<Ring>::from(vertex) - ray.origin;
    };
    const Vector<Ring> to_a = seen(triangle.a), to_b = seen(triangle.b), to_c = seen(triangle.c);
    a = dot(ray.direction, cross(to_b, to_c));
    b = dot(ray.direction, cross(to_c, to_a));
    c = dot(ray.direction, cross(to_a, to_b));
  }

  [[nodiscard]] Ring sum() const { return a + b + c; }

  /// Whether the line meets the closed triangle, where it is not parallel to it.
  [[nodiscard]] bool is_inside() const {
    const int whole = sign(sum());
    return sign(a) * whole >= 0 && sign(b) * whole >= 0 && sign(c) * whole >= 0;
  }
  /// On how many of the sides' lines the meeting point lies.
  [[nodiscard]] int zeros() const {
    return static_cast<int>(sign(a) == 0) + static_cast<int>(sign(b) == 0) + static_cast<int>(sign(c) == 0);
  }
};

}  // namespace rayproof::oracle
