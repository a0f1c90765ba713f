#pragma once
#include <rayproof/polygon/ray_segment.hpp>
#include <rayproof/vec3.hpp>

namespace rayproof::polygon {

/// Newell's normal, twice the area of the polygon: Σ (vᵢ - v₀)×(vᵢ₊₁ - v₀), which is Σ vᵢ×vᵢ₊₁ without the
/// loss of digits far from the origin. 0 where the projected areas cancel.
///
/// Source: I. Sutherland, R. Sproull, R. Schumacker, "A Characterization of Ten Hidden-Surface Algorithms",
/// 1974, where the method is credited to M. Newell.
template <class T, class Vertices>
[[nodiscard]] vec3<T> newell_normal(const Vertices& vertices) {
  vec3<T> normal{T(0), T(0), T(0)};
  for_each_side(vertices, [&](const vec3<T>& a, const vec3<T>& b) {
    normal = normal + cross(a - vertices.front(), b - vertices.front());
  });
  return normal;
}

}  // namespace rayproof::polygon
