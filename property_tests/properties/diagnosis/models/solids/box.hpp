#pragma once
/// \file
/// Models of a box whose middle, half size or corner is taken wrongly.

#include <utility>

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// @{ The whole size stands for half of it; half of it for the whole; min + max for the middle; max for half
/// the size of a box about the origin of coordinates.
[[nodiscard]] std::vector<Case> size_as_half(const Case& one);
[[nodiscard]] std::vector<Case> half_as_size(const Case& one);
[[nodiscard]] std::vector<Case> sum_as_middle(const Case& one);
[[nodiscard]] std::vector<Case> max_as_half_size(const Case& one);
/// @}

/// @{ The box from min with all sides as long as that one, or as the longest.
[[nodiscard]] std::vector<Case> with_sides(const Case& one, double (*length)(const glm::dvec3& sides));
template <int side>
[[nodiscard]] std::vector<Case> sides_alike(const Case& one) {
  return with_sides(one, [](const glm::dvec3& sides) { return sides[side]; });
}
[[nodiscard]] std::vector<Case> sides_as_longest(const Case& one);
/// @}

/// @{ The box with a corner read otherwise; where the corners then lie the wrong way round, the box between
/// them or none. A coordinate stands in the place of that on axis `to`, or the two are exchanged.
using Corner = glm::dvec3 Box<double>::*;
[[nodiscard]] Answers with_corner(const Case& one, Corner corner, void (*change)(glm::dvec3&));
template <Corner corner, int from, int to>
[[nodiscard]] Answers corner_copied(const Case& one, const Answer& /*exact*/) {
  return with_corner(one, corner, [](glm::dvec3& v) { v[to] = v[from]; });
}
template <Corner corner, int i, int j>
[[nodiscard]] Answers corner_exchanged(const Case& one, const Answer& /*exact*/) {
  return with_corner(one, corner, [](glm::dvec3& v) { std::swap(v[i], v[j]); });
}
/// @}

/// The normal is that of the face along the axis in which the point is farthest from the middle, the size of
/// the box not looked at.
[[nodiscard]] Answers normal_of_farthest_axis(const Case& one, const Answer& exact);

/// Whether the normal of the entry is turned round where the ray begins on that face, or behind it, and only
/// there: its sign is that of the side of the origin.
[[nodiscard]] std::optional<bool> normal_signed_by_origin(const Case& one, const Answer& got,
                                                          const Answer& exact);
/// Where the ray starts inside the normal is along the axis of the entry, and must be along the exit's: with
/// the sign of the direction, or as it is at the entry.
[[nodiscard]] Answers normal_of_entry_axis(const Case& one, const Answer& exact);

/// In a case of float64 the middle and the half size of the box are floats.
[[nodiscard]] std::vector<Case> middle_in_float(const Case& one);

}  // namespace rayproof::diagnosis
