#pragma once
/// \file
/// The normal of a polygon in space.

#include "oracle/geometry/scene.hpp"

namespace rayproof::oracle {

/// The Newell normal: the sum of the cross products of neighbouring vertices, twice the polygon's vector
/// area; zero where the area is. Each coordinate is written as the sum of one of a vertex, times the step of
/// another from the vertex before to the vertex after: half the products.
///
/// Source: I. E. Sutherland, R. F. Sproull, R. A. Schumacker, "A Characterization of Ten Hidden-Surface
/// Algorithms", 1974 (attributed to M. Newell).
template <class R>
[[nodiscard]] Vector<R> newell_normal(const Polygon<double>& polygon) {
  const std::vector<glm::dvec3>& vertices = polygon.vertices;
  Vector<R> normal{R(0.0), R(0.0), R(0.0)};
  const glm::dvec3* before = &vertices.back();
  for (const glm::dvec3& vertex : vertices) {
    const glm::dvec3& after = &vertex == &vertices.back() ? vertices.front() : *(&vertex + 1);
    const auto at = Vector<R>::from(vertex), step = step_between<R>(*before, after);
    normal = normal + Vector<R>{at.y * step.z, at.z * step.x, at.x * step.y};
    before = &vertex;
  }
  return normal;
}

}  // namespace rayproof::oracle
