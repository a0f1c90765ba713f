#pragma once
/// \file
/// The normal of a polygon in space.

#include "oracle/geometry/scene.hpp"

namespace rayproof::oracle {

/// The Newell normal: the sum of the cross products of neighbouring vertices, twice the polygon's vector
/// area; zero where the area is.
///
/// Source: I. E. Sutherland, R. F. Sproull, R. A. Schumacker, "A Characterization of Ten Hidden-Surface
/// Algorithms", 1974 (attributed to M. Newell).
template <class R>
[[nodiscard]] Vector<R> newell_normal(const Polygon<double>& polygon) {
  Vector<R> normal{R(0.0), R(0.0), R(0.0)};
  auto from = Vector<R>::from(polygon.vertices.back());
  for (const glm::dvec3& vertex : polygon.vertices) {
    const auto to = Vector<R>::from(vertex);
    normal = normal + cross(from, to);
    from = to;
  }
  return normal;
}

}  // namespace rayproof::oracle
