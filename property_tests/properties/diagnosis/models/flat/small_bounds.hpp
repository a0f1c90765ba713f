#pragma once
/// \file
/// Models of faults in a sphere round a flat figure that is to spare rays which pass far by.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// A triangle is missed where the ray's line passes by a sphere that does not hold all of it: one round two
/// of the vertices alone, or round the middle of all three as far as one or two of them. An answer for each
/// such sphere, always in the same order.
[[nodiscard]] Answers beyond_small_sphere(const Case& one, const Answer& exact);

/// A polygon is missed where the hit, or the ray's line, is outside of a sphere that does not hold all of it:
/// one round its first vertex, or round the mean of all, as far as some of the vertices or as long as some of
/// the sides. An answer for each such sphere, always in the same order.
[[nodiscard]] Answers polygon_beyond_small_sphere(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
