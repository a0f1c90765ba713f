#pragma once
#include <rayproof/formulas/polygon_sides.hpp>
#include <rayproof/vec3.hpp>

namespace rayproof::polygon {

/// Newell's normal, twice the area of the polygon: Σ (vᵢ - r)×(vᵢ₊₁ - r), which is Σ vᵢ×vᵢ₊₁ whatever r is.
/// 0 where the projected areas cancel.
///
/// With a vertex for r, a polygon far from the origin keeps its digits; with the one nearest the origin, no
/// factor is more than twice as long as its vertex, so that rounding stays within the unit of the contracts.
///
/// Source: I. Sutherland, R. Sproull, R. Schumacker, "A Characterization of Ten Hidden-Surface Algorithms",
/// 1974, where the method is credited to M. Newell.
template <class T, class Vertices>
[[nodiscard]] vec3<T> newell_normal(const Vertices& vertices, const vec3<T>& r) {
  vec3<T> normal{T(0), T(0), T(0)};
  for_each_side(vertices, [&](const vec3<T>& a, const vec3<T>& b) { normal = normal + cross(a - r, b - r); });
  return normal;
}

/// The vertex nearest the origin.
template <class Vertices>
[[nodiscard]] auto nearest_the_origin(const Vertices& vertices) {
  auto nearest = vertices.front();
  for (const auto& v : vertices) {
    if (dot(v, v) < dot(nearest, nearest)) nearest = v;
  }
  return nearest;
}

}  // namespace rayproof::polygon
