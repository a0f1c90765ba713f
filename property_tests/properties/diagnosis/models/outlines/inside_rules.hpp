#pragma once
/// \file
/// Wrong rules for the question whether a point lies in a polygon.

#include "properties/diagnosis/models/outlines/outline_geometry.hpp"

namespace rayproof::diagnosis {

/// A rule that a subject may follow in place of the even-odd one: whether the point is inside by it, a vertex
/// on its level counting as below it.
using InsideRule = bool (*)(const glm::dvec2& point, const Outline& outline);

namespace inside {

/// Sides closed at both ends, or open at both: a level vertex counts twice or never.
[[nodiscard]] bool closed_sides(const glm::dvec2& point, const Outline& outline);
/// A side has its first vertex and not its second, whichever is higher.
[[nodiscard]] bool closed_at_first(const glm::dvec2& point, const Outline& outline);
/// A side level with the point counts as crossed, too.
[[nodiscard]] bool level_sides(const glm::dvec2& point, const Outline& outline);
/// The point must not be level with a vertex: then it is outside.
[[nodiscard]] bool not_level(const glm::dvec2& point, const Outline& outline);
/// The point's two coordinates stand in each other's place.
[[nodiscard]] bool exchanged(const glm::dvec2& point, const Outline& outline);
/// What winds round the point any number of times but 0 is inside.
[[nodiscard]] bool winding(const glm::dvec2& point, const Outline& outline);
/// A side goes on without end beyond its second vertex.
[[nodiscard]] bool endless_sides(const glm::dvec2& point, const Outline& outline);
/// x is not compared: crossings on both sides of the point count, half of them.
[[nodiscard]] bool both_ways(const glm::dvec2& point, const Outline& outline);
/// The side from the last vertex to the first is forgotten.
[[nodiscard]] bool last_side(const glm::dvec2& point, const Outline& outline);
/// Only the first three vertices are looked at.
[[nodiscard]] bool first_triangle(const glm::dvec2& point, const Outline& outline);
/// An upright side counts on whichever side of the point it lies.
[[nodiscard]] bool upright_sides(const glm::dvec2& point, const Outline& outline);
/// A vertex that was there before is left out.
[[nodiscard]] bool unrepeated(const glm::dvec2& point, const Outline& outline);
/// An inequality is multiplied by a negative height, and not turned round.
[[nodiscard]] bool unturned(const glm::dvec2& point, const Outline& outline);
/// x is compared with that of a side's first vertex, not with the crossing's.
[[nodiscard]] bool first_end(const glm::dvec2& point, const Outline& outline);
/// x is compared with that of a side's second vertex.
[[nodiscard]] bool second_end(const glm::dvec2& point, const Outline& outline);
/// x is compared with the larger x of a side's two vertices.
[[nodiscard]] bool farther_end(const glm::dvec2& point, const Outline& outline);
/// One crossed side is enough, and none more changes it.
[[nodiscard]] bool any_crossing(const glm::dvec2& point, const Outline& outline);
/// Sides that run in one direction, upward or downward, count alone.
[[nodiscard]] bool upward(const glm::dvec2& point, const Outline& outline);
/// Inside is where all sides turn one way: right for convex polygons only.
[[nodiscard]] bool one_side(const glm::dvec2& point, const Outline& outline);
/// Inside is what lies in a triangle of the fan from the first vertex.
[[nodiscard]] bool fan(const glm::dvec2& point, const Outline& outline);
/// The angles at which the sides are seen, without a sign, add up to a whole turn.
[[nodiscard]] bool angles(const glm::dvec2& point, const Outline& outline);
/// These angles add up to a whole turn or more.
[[nodiscard]] bool angles_or_more(const glm::dvec2& point, const Outline& outline);
/// These angles add up to an odd number of turns, rounded.
[[nodiscard]] bool angles_rounded(const glm::dvec2& point, const Outline& outline);
/// Twice the area that a side spans with the point is cut off to a whole number.
[[nodiscard]] bool cut_off_turns(const glm::dvec2& point, const Outline& outline);
/// What lies outside the bounding box of the first three vertices is outside.
[[nodiscard]] bool bounds_of_three(const glm::dvec2& point, const Outline& outline);
/// The bounding box.
[[nodiscard]] bool bounds(const glm::dvec2& point, const Outline& outline);

}  // namespace inside

}  // namespace rayproof::diagnosis
