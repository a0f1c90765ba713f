#pragma once
/// \file
/// Cures: changes of a case after which a subject with a certain fault is right. Each is a Change of
/// hypothesis.hpp and returns the changed cases, the mildest change first; none where it is not for the case.

#include "properties/diagnosis/changes.hpp"
#include "properties/diagnosis/hypothesis.hpp"

namespace rayproof::diagnosis {

using Cases = std::vector<Case>;

/// The case itself.
[[nodiscard]] Cases unchanged(const Case& one);
/// @{ The direction: of unit length; tilted off the axes by a thousandth without moving the hit; without
/// components below a millionth of the largest; of positive components, the scene mirrored with it.
[[nodiscard]] Cases unit_direction(const Case& one);
[[nodiscard]] Cases tilted(const Case& one);
[[nodiscard]] Cases without_tiny_component(const Case& one);
[[nodiscard]] Cases positive_direction(const Case& one);
/// @}
/// Every -0 becomes 0.
[[nodiscard]] Cases without_minus_zero(const Case& one);

/// @{ Lengths, the direction, or the equation times powers of two.
[[nodiscard]] Cases larger_scene(const Case& one);
[[nodiscard]] Cases smaller_scene(const Case& one);
[[nodiscard]] Cases longer_direction(const Case& one);
[[nodiscard]] Cases shorter_direction(const Case& one);
/// Scene and direction both, to sizes of about 1.
[[nodiscard]] Cases ordinary_sizes(const Case& one);
/// @}

/// @{ The place: the shape at the origin of coordinates; the ray's origin near the shape; the ray started
/// before its line meets anything; [0, inf] for an interval; the scene in the object's space.
[[nodiscard]] Cases shape_at_zero(const Case& one);
[[nodiscard]] Cases start_near(const Case& one);
[[nodiscard]] Cases start_behind(const Case& one);
[[nodiscard]] Cases plain_interval(const Case& one);
[[nodiscard]] Cases in_object_space(const Case& one);
/// @}

/// The scene turned so that nothing lies along an axis.
[[nodiscard]] Cases turned(const Case& one);
/// @{ Flat figures: met at a steep angle at the same point; a triangle made as wide as it is long.
[[nodiscard]] Cases steeper(const Case& one);
[[nodiscard]] Cases wider(const Case& one);
/// @}

/// @{ The ray moved aside: towards the middle of the shape, and away from it.
[[nodiscard]] Cases nearer_the_middle(const Case& one);
[[nodiscard]] Cases farther_off(const Case& one);
/// @}

/// @{ The ray moved aside, or the interval widened, by a millionth of the scene; or by a thousandth, where
/// the hit is not on a boundary.
[[nodiscard]] Cases off_boundary(const Case& one);
[[nodiscard]] Cases off_interval_ends(const Case& one);
[[nodiscard]] Cases off_level(const Case& one);
/// @}

/// @{ Digits: the same numbers in double; numbers of few digits, with which little is rounded; every number
/// changed a little.
[[nodiscard]] Cases in_double(const Case& one);
[[nodiscard]] Cases few_digits(const Case& one);
[[nodiscard]] Cases jiggled(const Case& one);
/// @}
/// No cure: every number changed by up to an eighth, another way for each seed.
[[nodiscard]] Cases varied(const Case& one, std::uint64_t seed);

/// @{ The shape: with another of its vertices as the first; wound the other way round; with its axes renamed;
/// with a normal, edges, of unit length; with orthogonal edges.
[[nodiscard]] Cases other_first_vertex(const Case& one);
[[nodiscard]] Cases reversed_winding(const Case& one);
[[nodiscard]] Cases renamed_axes(const Case& one);
[[nodiscard]] Cases unit_normal(const Case& one);
[[nodiscard]] Cases unit_edges(const Case& one);
/// @}

/// @{ The equation: with a > 0; with a = 1; where b² is not much larger than 4ac.
[[nodiscard]] Cases positive_a(const Case& one);
[[nodiscard]] Cases leading_one(const Case& one);
[[nodiscard]] Cases small_b(const Case& one);
/// @}

}  // namespace rayproof::diagnosis
