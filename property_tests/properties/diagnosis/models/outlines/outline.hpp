#pragma once
/// \file
/// Models of faults in the question whether a point lies in a polygon, in the plane or in space.

#include <cmath>

#include "properties/boundary.hpp"
#include "properties/diagnosis/models/models.hpp"
#include "properties/diagnosis/models/outlines/inside_rules.hpp"
#include "properties/diagnosis/models/outlines/sweep.hpp"

namespace rayproof::diagnosis {

/// Whether the point is inside by the even-odd rule.
[[nodiscard]] bool is_inside_outline(const PlaneHit& hit);

/// What a subject may answer that follows the rule, a vertex on the point's level counting as below or as
/// above; none for points on the boundary.
[[nodiscard]] Answers inside_by(const Case& one, const Answer& exact, InsideRule rule, Sweep sweep);
template <InsideRule rule, Sweep sweep = Sweep::along>
[[nodiscard]] Answers inside_by(const Case& one, const Answer& exact) {
  return inside_by(one, exact, rule, sweep);
}

/// The same of a polygon in space whose hit is looked for with its two coordinates exchanged.
[[nodiscard]] Answers exchanged_in_projection(const Case& one, const Answer& exact);

/// The polygon's plane is that of its first three vertices; where these lie on a line it is missed.
[[nodiscard]] Answers plane_of_corner(const Case& one, const Answer& exact);

/// Whether a point at a vertex lies on more sides than the two that meet there.
[[nodiscard]] bool is_on_third_side(const Case& one);

/// A point of the polygon's boundary at that kind of place is said to be outside, or inside. One on a third
/// side may be found there.
template <BoundaryPlace place>
[[nodiscard]] Answers lost_at(const Case& one, const Answer& exact) {
  const auto* position = std::get_if<Position>(&exact);
  if (position == nullptr || !boundary_places(one).test(static_cast<std::size_t>(place))) return {};
  if (place == BoundaryPlace::vertex && is_on_third_side(one)) return {};
  return {Position::outside, Position::inside};
}

/// A point of a side that is no vertex is said to be outside, or inside.
[[nodiscard]] inline Answers lost_between_vertices(const Case& one, const Answer& exact) {
  const auto* position = std::get_if<Position>(&exact);
  if (position == nullptr || *position != Position::boundary) return {};
  const bool is_vertex = boundary_places(one).test(static_cast<std::size_t>(BoundaryPlace::vertex));
  return is_vertex ? Answers{} : Answers{Position::outside, Position::inside};
}

/// A point on the line of a side, beyond its ends, is said to be on the boundary, at least inside the
/// bounding box.
[[nodiscard]] Answers endless_boundary(const Case& one, const Answer& exact);
/// The same of the line of an upright side alone, or of one without length.
[[nodiscard]] Answers endless_upright_boundary(const Case& one, const Answer& exact);

/// A point of the boundary that lies on the border of the bounding box is said to be outside.
[[nodiscard]] Answers lost_on_bounds(const Case& one, const Answer& exact);

/// The same at its greatest x or y alone.
[[nodiscard]] Answers lost_at_greatest(const Case& one, const Answer& exact);

/// No point is ever said to be inside.
[[nodiscard]] Answers never_inside(const Case& one, const Answer& exact);
/// Inside is called outside, and outside inside.
[[nodiscard]] Answers inside_out(const Case& one, const Answer& exact);

/// The polygon of the case is not convex, and the answer is wrong.
[[nodiscard]] std::optional<bool> wrong_where_concave(const Case& one, const Answer& got,
                                                      const Answer& exact);

}  // namespace rayproof::diagnosis
