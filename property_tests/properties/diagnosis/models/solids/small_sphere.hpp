#pragma once
/// \file
/// Models of an early test whether the line passes near enough to a solid: by its sphere, or one round it.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// What the line passes at a distance whose square is larger than the radius, or which is larger than the
/// radius squared, is missed: of a sphere, or of that round a box or parallelepiped. An answer for each.
[[nodiscard]] Answers square_beside_radius(const Case& one, const Answer& exact);

/// A box or parallelepiped is missed where the line passes its middle farther away than half of its longest
/// edge, half of its shortest, or a quarter of its diagonal. An answer for each.
[[nodiscard]] Answers solid_beyond_small_sphere(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
