#pragma once
/// \file
/// Models of faults in a sphere round a triangle that is to spare rays which pass far by.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// A triangle is missed where the ray's line passes by a sphere that does not hold all of it: one round two
/// of the vertices alone, or round the middle of all three as far as one or two of them. An answer for each
/// such sphere, always in the same order.
[[nodiscard]] Answers beyond_small_sphere(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
