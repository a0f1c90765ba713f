#pragma once
/// \file
/// The sides of polygons: Newell's normal in space, and rays along +x in the plane, the raw material of every
/// crossing count.

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <rayproof/arithmetic.hpp>
#include <rayproof/formulas/finite.hpp>
#include <rayproof/polygon.hpp>
#include <utility>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::polygon {

/// Where the ray point + t·(1, 0) meets the line through a and b, which is at a + s·(b - a). For a horizontal
/// line s and t are infinite or NaN.
template <class T>
struct Crossing {
  T s;
  T t;
};

/// Source: R. Bán, "Számítógépes grafika: Raycasting", 2022.
template <class T>
[[nodiscard]] constexpr Crossing<T> cross_side(const Vec2<T>& point, const Vec2<T>& a, const Vec2<T>& b) {
  const T s = (point.y - a.y) / (b.y - a.y);
  return {s, (a.x - point.x) + s * (b.x - a.x)};
}

/// Whether a side whose ends are at the heights a and b leads from the line y = level, or below it, to above
/// it, or back: a side holds its lower end and not its upper one, so a chain of sides through the line counts
/// once, one that touches it twice or not at all, and a horizontal side never.
template <class T>
[[nodiscard]] constexpr bool passes(const T& level, const T& a, const T& b) {
  return (a <= level) != (b <= level);
}
/// The same of the side from vertex a to vertex b.
template <class T>
[[nodiscard]] constexpr bool passes(const T& level, const Vec2<T>& a, const Vec2<T>& b) {
  return passes(level, a.y, b.y);
}

/// Whether a point on the line through a and b lies between them, ends included.
template <class T>
[[nodiscard]] constexpr bool is_between(const Vec2<T>& point, const Vec2<T>& a, const Vec2<T>& b) {
  return min(a.x, b.x) <= point.x && point.x <= max(a.x, b.x) && min(a.y, b.y) <= point.y &&
         point.y <= max(a.y, b.y);
}

/// A list whose elements are made when they are asked for: vertices in another arithmetic, say.
template <class Make>
struct MadeInTurn {
  std::size_t count;
  Make make;

  [[nodiscard]] constexpr std::size_t size() const { return count; }
  [[nodiscard]] constexpr auto operator[](std::size_t i) const { return make(i); }
};
template <class Make>
MadeInTurn(std::size_t, Make) -> MadeInTurn<Make>;

/// The vertex after vertex i of a closed polygon.
[[nodiscard]] constexpr std::size_t next(std::size_t i, std::size_t vertex_count) {
  return i + 1 < vertex_count ? i + 1 : 0;
}

/// Calls `visit(vᵢ, vᵢ₊₁)` for each side, the last one back to vertices[0].
template <class Vertices, class Visit>
constexpr void for_each_side(const Vertices& vertices, Visit&& visit) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    visit(vertices[i], vertices[next(i, vertices.size())]);
  }
}

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
  vec3<T> b = vertices[0] - r;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const vec3<T> a = std::exchange(b, vertices[next(i, vertices.size())] - r);
    normal = normal + cross(a, b);
  }
  return normal;
}

/// The vertex nearest the origin.
template <class Vertices>
[[nodiscard]] auto nearest_the_origin(const Vertices& vertices) {
  return *std::min_element(vertices.begin(), vertices.end(),
                           [](const auto& a, const auto& b) { return dot(a, a) < dot(b, b); });
}

/// No coordinate is NaN or infinite: a crossing count takes no notice of a side it can't compare.
template <Branching T>
[[nodiscard]] bool is_finite(const PointAndPolygon<T>& question) {
  return are_finite(question.point, question.vertices);
}

}  // namespace rayproof::polygon

#include <rayproof/rounding/as_before.hpp>
