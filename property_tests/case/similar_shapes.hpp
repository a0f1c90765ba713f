#pragma once
/// \file
/// How each shape grows with its scene: one function a shape, the shape in a scene `factor` times as large
/// about the origin of coordinates.

#include "case/case.hpp"

namespace rayproof {

[[nodiscard]] inline Sphere<double> grown(const Sphere<double>& sphere, double factor) {
  return {factor * sphere.center, factor * sphere.radius};
}

/// The normal has no length to grow.
[[nodiscard]] inline ImplicitPlane grown(const ImplicitPlane& plane, double factor) {
  return {plane.normal, factor * plane.d};
}

[[nodiscard]] inline PointNormalPlane grown(const PointNormalPlane& plane, double factor) {
  return {factor * plane.point, plane.normal};
}

[[nodiscard]] inline ParametricPlane grown(const ParametricPlane& plane, double factor) {
  return {factor * plane.point, factor * plane.u, factor * plane.v};
}

[[nodiscard]] inline Triangle<double> grown(const Triangle<double>& triangle, double factor) {
  return {factor * triangle.a, factor * triangle.b, factor * triangle.c};
}

[[nodiscard]] inline Polygon<double> grown(Polygon<double> polygon, double factor) {
  for (glm::dvec3& vertex : polygon.vertices) vertex *= factor;
  return polygon;
}

[[nodiscard]] inline Box<double> grown(const Box<double>& box, double factor) {
  return {factor * box.min, factor * box.max};
}

[[nodiscard]] inline Parallelepiped<double> grown(const Parallelepiped<double>& solid, double factor) {
  return {factor * solid.corner, {factor * solid.edges[0], factor * solid.edges[1], factor * solid.edges[2]}};
}

[[nodiscard]] inline Cylinder<double> grown(const Cylinder<double>& cylinder, double factor) {
  return {factor * cylinder.rx, factor * cylinder.ry, factor * cylinder.height, cylinder.capped};
}

/// A point in a polygon: both grow.
[[nodiscard]] inline PointAndPolygon<double> grown(PointAndPolygon<double> question, double factor) {
  const auto grow = [factor](Vec2<double>& v) { v = {factor * v.x, factor * v.y}; };
  grow(question.point);
  for (Vec2<double>& vertex : question.vertices) grow(vertex);
  return question;
}

}  // namespace rayproof
