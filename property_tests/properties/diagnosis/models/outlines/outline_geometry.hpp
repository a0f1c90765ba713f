#pragma once
/// \file
/// A point and a closed outline in the plane, as the models of faults need them: in doubles.

#include <glm/vec2.hpp>
#include <utility>

#include "properties/diagnosis/models/plane_hit.hpp"

namespace rayproof::diagnosis {

/// The vertices, in order; the last side leads back to the first.
using Outline = std::vector<glm::dvec2>;

/// The point of the case and the outline that it is asked to lie in: as they stand, or where the line meets
/// the plane of a polygon or triangle; nothing where there are none.
[[nodiscard]] std::optional<PlaneHit> point_and_outline(const Case& one);

/// Twice the area of abc, positive where it turns left.
[[nodiscard]] inline double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether a side crosses the level of the point, by the heights of its ends over it: an end on the level
/// counts as below.
[[nodiscard]] inline bool half_open(double from, double to) { return (from <= 0) != (to <= 0); }

/// How often a ray from the point along x crosses the first sides; `counts(from, to)` of the heights of a
/// side's ends over the point decides whether a side is crossed at all.
template <class Counts>
[[nodiscard]] int crossings(const glm::dvec2& point, const Outline& outline, std::size_t sides,
                            Counts&& counts) {
  int sum = 0;
  for (std::size_t i = 0; i < sides; ++i) {
    const glm::dvec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    if (a.y == b.y || !counts(a.y - point.y, b.y - point.y)) continue;
    if (a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x) >= point.x) ++sum;
  }
  return sum;
}

/// How often the outline winds round the point.
[[nodiscard]] int windings(const glm::dvec2& point, const Outline& outline);

/// The bounding box of the outline: its lower and its upper corner.
[[nodiscard]] std::pair<glm::dvec2, glm::dvec2> bounds_of(const Outline& outline);
[[nodiscard]] bool is_in_bounds(const glm::dvec2& point, const Outline& outline);

/// Whether all sides turn one way round the point.
[[nodiscard]] bool is_on_one_side(const glm::dvec2& point, const Outline& outline);

/// The sides that are no farther from the point than that, by their first vertices.
[[nodiscard]] std::vector<std::size_t> sides_within(double distance, const glm::dvec2& point,
                                                    const Outline& outline);

/// Whether the point is so near a side that rounding decides.
[[nodiscard]] bool is_at_side(Precision precision, const glm::dvec2& point, const Outline& outline);

}  // namespace rayproof::diagnosis
