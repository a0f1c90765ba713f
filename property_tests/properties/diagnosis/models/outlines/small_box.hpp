#pragma once
/// \file
/// Models of faults in a box round a polygon that is to spare points which lie outside.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// What lies outside the bounding box of all vertices but one, the first or the last, is said to be outside:
/// beyond any of its borders, or beyond one alone. An answer for each, always in the same order.
[[nodiscard]] Answers outside_small_box(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
