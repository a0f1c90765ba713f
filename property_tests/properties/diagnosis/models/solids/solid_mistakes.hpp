#pragma once
/// \file
/// Models of mistakes with a solid's three intervals that no other reading of the solid stands for.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// A line that leaves the solid beyond t_max is missed, though it enters before.
[[nodiscard]] Answers exit_beyond_end_missed(const Case& one, const Answer& exact);
/// The nearer end of a slab is compared with the last one so far, and the farther end only where that was not
/// larger ("else if"): the beginnings first, or the ends first.
[[nodiscard]] Answers slab_ends_in_else(const Case& one, const Answer& exact);
/// Of a parallelepiped the half, or the tetrahedron, in which the coordinates' sum is at most 1.
[[nodiscard]] Answers sum_of_coordinates_tested(const Case& one, const Answer& exact);
/// The direction, or the way from the corner, goes into the edges' frame by the transposed inverse. An answer
/// for each, in this order.
[[nodiscard]] Answers one_by_transposed(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
