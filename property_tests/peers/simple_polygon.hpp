#pragma once
/// \file
/// Whether a polygon is what most libraries mean by one: flat, of some area, with sides that meet at their
/// ends alone. Computed in double, and in doubt it is not.

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "answer_cases.hpp"

namespace rayproof::peers {

/// Twice the signed area of a b c, or 0 where rounding may have decided its sign.
[[nodiscard]] inline double turn(Vec2<double> a, Vec2<double> b, Vec2<double> c) {
  const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x);
  const double area = left - right;
  return std::abs(area) > 1e-14 * (std::abs(left) + std::abs(right)) ? area : 0;
}

/// Whether two segments may have a point in common.
[[nodiscard]] inline bool may_meet(Vec2<double> a, Vec2<double> b, Vec2<double> c, Vec2<double> d) {
  const auto apart = [](double p, double q) { return (p > 0 && q > 0) || (p < 0 && q < 0); };
  const auto beside = [](double p, double q, double r, double s) {
    return std::max(p, q) < std::min(r, s) || std::max(r, s) < std::min(p, q);
  };
  if (beside(a.x, b.x, c.x, d.x) || beside(a.y, b.y, c.y, d.y)) return false;
  return !apart(turn(a, b, c), turn(a, b, d)) && !apart(turn(c, d, a), turn(c, d, b));
}

/// Whether no two sides meet, but neighbours at their common vertex, and no side has length 0.
[[nodiscard]] inline bool is_simple(std::span<const Vec2<double>> vertices) {
  const std::size_t n = vertices.size();
  const auto at = [&](std::size_t i) { return vertices[i % n]; };
  for (std::size_t i = 0; i < n; ++i) {
    if (turn(at(i), at(i + 1), at(i + 2)) == 0) return false;  // a spike, a repeated or a needless vertex
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && may_meet(at(i), at(i + 1), at(j), at(j + 1))) return false;
  }
  return true;
}

/// The Newell normal of a polygon seen from its first vertex.
[[nodiscard]] inline glm::dvec3 newell_normal(std::span<const glm::dvec3> vertices) {
  glm::dvec3 normal(0);
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
    normal += cross(vertices[i] - vertices[0], vertices[i + 1] - vertices[0]);
  return normal;
}

/// How far the farthest vertex is from the plane through the first with this normal, a unit vector.
[[nodiscard]] inline double distance_from_plane(std::span<const glm::dvec3> vertices,
                                                const glm::dvec3& normal) {
  double distance = 0;
  for (const glm::dvec3& vertex : vertices)
    distance = std::max(distance, std::abs(dot(vertex - vertices[0], normal)));
  return distance;
}

/// How far a point is from the nearest side.
[[nodiscard]] inline double distance_from_sides(std::span<const glm::dvec3> vertices,
                                                const glm::dvec3& point) {
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const glm::dvec3& from = vertices[i];
    const glm::dvec3 side = vertices[(i + 1) % vertices.size()] - from;
    const double share = std::clamp(dot(point - from, side) / dot(side, side), 0.0, 1.0);
    distance = std::min(distance, glm::length(point - from - share * side));
  }
  return distance;
}

/// Whether a polygon in space is one, where all vertices also lie in one plane, but for a rounding in double.
[[nodiscard]] inline bool is_simple(std::span<const glm::dvec3> vertices) {
  const glm::dvec3 normal = newell_normal(vertices);
  double size = 0;
  for (const glm::dvec3& vertex : vertices) size = std::max(size, glm::length(vertex - vertices[0]));
  if (!(glm::length(normal) > 1e-12 * size * size) ||
      distance_from_plane(vertices, glm::normalize(normal)) > 1e-13 * size)
    return false;
  int axis = 0;
  for (const int other : {1, 2})
    if (std::abs(normal[other]) >= std::abs(normal[axis])) axis = other;
  std::vector<Vec2<double>> flat;
  flat.reserve(vertices.size());
  for (const glm::dvec3& vertex : vertices) flat.push_back({vertex[(axis + 1) % 3], vertex[(axis + 2) % 3]});
  return is_simple(flat);
}

}  // namespace rayproof::peers
