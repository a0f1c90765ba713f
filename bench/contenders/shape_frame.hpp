#pragma once
/// \file
/// A shape's own coordinates: two shapes of a kind are alike in them, wherever they lie and whatever their
/// size.

#include <glm/mat3x3.hpp>
#include <rayproof/topics.hpp>

namespace rayproof::report {

struct ShapeFrame {
  glm::dvec3 origin;
  glm::dmat3 axes;
};

/// Three edges; of two, the third is their normal.
[[nodiscard]] inline glm::dmat3 spanned_by(const glm::dvec3& u, const glm::dvec3& v) {
  return {u, v, glm::cross(u, v)};
}

[[nodiscard]] inline ShapeFrame frame_of(const Sphere<double>& s) { return {s.center, glm::dmat3(s.radius)}; }
[[nodiscard]] inline ShapeFrame frame_of(const Triangle<double>& t) {
  return {t.a, spanned_by(t.b - t.a, t.c - t.a)};
}
[[nodiscard]] inline ShapeFrame frame_of(const Box<double>& b) {
  const glm::dvec3 size = b.max - b.min;
  return {b.min, {size.x, 0, 0, 0, size.y, 0, 0, 0, size.z}};
}
[[nodiscard]] inline ShapeFrame frame_of(const Parallelepiped<double>& p) {
  return {p.corner, {p.edges[0], p.edges[1], p.edges[2]}};
}
[[nodiscard]] inline ShapeFrame frame_of(const Cylinder<double>& c) {
  return {{0, 0, 0}, {c.rx, 0, 0, 0, c.ry, 0, 0, 0, c.height}};
}
/// A plane has no place on itself that is its own: the point nearest the origin, and two axes at right
/// angles.
[[nodiscard]] inline ShapeFrame frame_of(const Plane<double>& p) {
  const auto [normal, d] = plane::as_implicit(p);
  const glm::dvec3 along =
      std::abs(normal.x) < std::abs(normal.y) ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(normal, along));
  return {-d / glm::dot(normal, normal) * normal, spanned_by(u, glm::normalize(glm::cross(normal, u)))};
}

}  // namespace rayproof::report
