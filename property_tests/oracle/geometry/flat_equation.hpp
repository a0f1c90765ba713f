#pragma once
/// \file
/// The planes of the flat shapes, over a ring.

#include "oracle/geometry/newell.hpp"

namespace rayproof::oracle {

/// The plane normal·q = offset in the object's space.
template <class R>
struct FlatEquation {
  Vector<R> normal;
  R offset;
};

/// The plane through a point.
template <class R>
[[nodiscard]] FlatEquation<R> plane_through(const glm::dvec3& point, const Vector<R>& normal) {
  return {normal, dot(normal, Vector<R>::from(point))};
}

/// The plane of a flat shape; a zero normal where the shape has no area.
template <class R>
[[nodiscard]] FlatEquation<R> equation_of(const ImplicitPlane& plane) {
  return {Vector<R>::from(plane.normal), R(-plane.d)};
}
template <class R>
[[nodiscard]] FlatEquation<R> equation_of(const PointNormalPlane& plane) {
  return plane_through(plane.point, Vector<R>::from(plane.normal));
}
template <class R>
[[nodiscard]] FlatEquation<R> equation_of(const ParametricPlane& plane) {
  return plane_through(plane.point, cross(Vector<R>::from(plane.u), Vector<R>::from(plane.v)));
}
/// With (b-a)×(c-a) as its normal.
template <class R>
[[nodiscard]] FlatEquation<R> equation_of(const Triangle<double>& triangle) {
  return plane_through(
      triangle.a, cross(step_between<R>(triangle.a, triangle.b), step_between<R>(triangle.a, triangle.c)));
}
template <class R>
[[nodiscard]] FlatEquation<R> equation_of(const Polygon<double>& polygon) {
  return plane_through(polygon.vertices.front(), newell_normal<R>(polygon));
}

}  // namespace rayproof::oracle
