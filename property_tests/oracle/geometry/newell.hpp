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
  const auto vertex = [&](std::size_t i) { return Vector<R>::from(vertices[i % vertices.size()]); };
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vector<R> at = vertex(i), step = vertex(i + 1) - vertex(i + vertices.size() - 1);
    normal = normal + Vector<R>{at.y * step.z, at.z * step.x, at.x * step.y};
  }
  return normal;
}

}  // namespace rayproof::oracle
