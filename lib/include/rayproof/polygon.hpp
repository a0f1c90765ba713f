#pragma once
/// \file
/// Polygons: in space, met by rays, and in the plane, holding points.

#include <rayproof/method/contract.hpp>
#include <rayproof/roots.hpp>
#include <vector>

namespace rayproof {

/// A closed polygon in space by the even-odd rule; it may be concave, cross itself, repeat vertices. Its
/// plane goes through `vertices[0]` with the Newell normal; hit point and vertices are projected along the
/// axis where that normal is largest in magnitude (ties: the later axis).
///
/// Units of the contracts. Let V = Σ|vᵢ||vᵢ₊₁| (which bounds the Newell normal; of n vertices, from 64 on,
/// n/64 times as much, since the roundings of a long sum add up), P the largest |vᵢ|, and L(t) the sum
/// |origin| + P + |t||direction|. *Residual* is |normal·(p(t) - v₀)| / (ε·V·L(t)). *Verdict* is the least
/// distance of the ray from a side of the polygon, or of an end of its interval from the polygon, in units
/// of ε·K·L(t) where it is nearest, K = D² / |Newell's normal|, D as below, or 1 where that is less: by so
/// much the rounding of the normal turns the plane, which moves the point where the ray meets it. A side is
/// taken to lie in the plane: a vertex that does not, below or above it, counts where it is projected. Or,
/// where the vertices are so far off the plane that the polygon is met otherwise when seen along another
/// axis, by how much the normal's largest component is larger than that axis's, in units of ε·V, if that is
/// less: rounding may choose the other one. *Ulp* is in ulps of the exact t. *Domain* speaks of all numbers
/// of the case that are not 0.
template <class T>
struct Polygon {
  std::vector<vec3<T>> vertices;
};

/// The same polygon in another arithmetic.
template <class To, class From>
[[nodiscard]] Polygon<To> convert(const Polygon<From>& polygon) {
  Polygon<To> other;
  other.vertices.reserve(polygon.vertices.size());
  for (const auto& vertex : polygon.vertices) other.vertices.push_back(convert<To>(vertex));
  return other;
}

/// A point and a closed polygon of the plane by the even-odd rule.
///
/// Units of the contracts. *Verdict* is the point's distance from the nearest side in units of ε·(|point| +
/// P), P the largest |vᵢ|; 0 for a point on the boundary. *Domain* speaks of all numbers of the case that are
/// not 0.
template <class T>
struct PointAndPolygon {
  Vec2<T> point;
  std::vector<Vec2<T>> vertices;
};

/// Where a point lies; the names of the case format.
enum class Position { outside, boundary, inside };

/// The same question in another arithmetic.
template <class To, class From>
[[nodiscard]] PointAndPolygon<To> convert(const PointAndPolygon<From>& from) {
  PointAndPolygon<To> other{{To(from.point.x), To(from.point.y)}, {}};
  for (const auto& v : from.vertices) other.vertices.push_back({To(v.x), To(v.y)});
  return other;
}

/// The bounds, in the units above, that robust methods keep (Claim::robust).
inline constexpr double polygon_robust_bound = 8;
inline constexpr double point_in_polygon_robust_bound = 4;

/// What every sound method says of its first hit. K = n·D² / |Newell's normal|, with n vertices, none farther
/// than D from the first; from 64 vertices on n/64 times as much, as V is.
inline constexpr HitBounds polygon_hit_bounds{.point = {.measured = 1.98, .promised = 2, .is_proven = true},
                                              .normal = {.measured = 2.74, .promised = 5}};

}  // namespace rayproof
