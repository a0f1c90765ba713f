#pragma once
/// \file
/// Models of faults in the question whether a point lies in a polygon, in the plane or in space.

#include <cmath>

#include "properties/boundary.hpp"
#include "properties/diagnosis/models/flat/sweep.hpp"
#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// Rules that a subject may follow in place of the even-odd one.
enum class InsideRule {
  closed_sides,      ///< sides closed at both ends, or open at both: a level vertex counts twice or never
  not_level,         ///< the point must not be level with a vertex: then it is outside
  winding,           ///< what winds round the point any number of times but 0 is inside
  endless_sides,     ///< a side goes on without end beyond its second vertex
  both_ways,         ///< x is not compared: crossings on both sides of the point count, half of them
  last_side,         ///< the side from the last vertex to the first is forgotten
  first_triangle,    ///< only the first three vertices are looked at
  first_four,        ///< only the first four
  first_eight,       ///< only the first eight
  upright_sides,     ///< an upright side counts on whichever side of the point it lies
  unrepeated,        ///< a vertex that was there before is left out
  unturned,          ///< an inequality is multiplied by a negative height, and not turned round
  first_end,         ///< x is compared with that of a side's first vertex, not with the crossing's
  second_end,        ///< with that of its second vertex
  farther_end,       ///< with the larger of the two
  any_crossing,      ///< one crossed side is enough, and none more changes it
  upward,            ///< sides that run in one direction, upward or downward, count alone
  one_side,          ///< inside is where all sides turn one way: right for convex polygons only
  fan,               ///< the triangles of the fan from the first vertex, all together
  angles,            ///< the angles at which the sides are seen, without a sign, add up to a whole turn
  angles_or_more,    ///< to a whole turn or more
  angles_rounded,    ///< to an odd number of turns, rounded
  bounds_of_three,   ///< what lies outside the bounding box of the first three vertices is outside
  bounds_but_first,  ///< what lies outside the bounding box of all vertices but the first is outside
  bounds             ///< the bounding box
};

/// Whether the point is inside by the even-odd rule.
[[nodiscard]] bool is_inside_outline(const PlaneHit& hit);

/// What a subject may answer that follows the rule, a vertex on the point's level counting as below or as
/// above; none for points on the boundary.
[[nodiscard]] Answers inside_by(const Case& one, const Answer& exact, InsideRule rule, Sweep sweep);
template <InsideRule rule, Sweep sweep = Sweep::along>
[[nodiscard]] Answers inside_by(const Case& one, const Answer& exact) {
  return inside_by(one, exact, rule, sweep);
}

/// What is no farther from a side than a share of the polygon's size is said to be inside.
[[nodiscard]] Answers near_sides_inside(const Case& one, const Answer& exact, double tolerance);
template <int power>
[[nodiscard]] Answers near_sides_inside(const Case& one, const Answer& exact) {
  return near_sides_inside(one, exact, std::pow(10.0, power));
}

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

/// No point is ever said to be inside.
[[nodiscard]] Answers never_inside(const Case& one, const Answer& exact);
/// Inside is called outside, and outside inside.
[[nodiscard]] Answers inside_out(const Case& one, const Answer& exact);

/// The polygon of the case is not convex, and the answer is wrong.
[[nodiscard]] std::optional<bool> wrong_where_concave(const Case& one, const Answer& got,
                                                      const Answer& exact);

}  // namespace rayproof::diagnosis
