#pragma once
/// \file
/// Wrong rules for the question whether a point lies in a polygon.

#include "properties/diagnosis/models/outlines/outline_geometry.hpp"

namespace rayproof::diagnosis {

/// Rules that a subject may follow in place of the even-odd one.
enum class InsideRule {
  closed_sides,     ///< sides closed at both ends, or open at both: a level vertex counts twice or never
  closed_at_first,  ///< a side has its first vertex and not its second, whichever is higher
  level_sides,      ///< a side level with the point counts as crossed, too
  not_level,        ///< the point must not be level with a vertex: then it is outside
  exchanged,        ///< the point's two coordinates stand in each other's place
  winding,          ///< what winds round the point any number of times but 0 is inside
  endless_sides,    ///< a side goes on without end beyond its second vertex
  both_ways,        ///< x is not compared: crossings on both sides of the point count, half of them
  last_side,        ///< the side from the last vertex to the first is forgotten
  first_triangle,   ///< only the first three vertices are looked at
  upright_sides,    ///< an upright side counts on whichever side of the point it lies
  unrepeated,       ///< a vertex that was there before is left out
  unturned,         ///< an inequality is multiplied by a negative height, and not turned round
  first_end,        ///< x is compared with that of a side's first vertex, not with the crossing's
  second_end,       ///< with that of its second vertex
  farther_end,      ///< with the larger of the two
  any_crossing,     ///< one crossed side is enough, and none more changes it
  upward,           ///< sides that run in one direction, upward or downward, count alone
  one_side,         ///< inside is where all sides turn one way: right for convex polygons only
  fan,              ///< the triangles of the fan from the first vertex, all together
  angles,           ///< the angles at which the sides are seen, without a sign, add up to a whole turn
  angles_or_more,   ///< to a whole turn or more
  angles_rounded,   ///< to an odd number of turns, rounded
  cut_off_turns,    ///< twice the area that a side spans with the point is cut off to a whole number
  bounds_of_three,  ///< what lies outside the bounding box of the first three vertices is outside
  bounds            ///< the bounding box
};

/// Whether the point is inside by that rule, a vertex on its level counting as below it.
[[nodiscard]] bool is_inside(InsideRule rule, const glm::dvec2& point, const Outline& outline);

}  // namespace rayproof::diagnosis
