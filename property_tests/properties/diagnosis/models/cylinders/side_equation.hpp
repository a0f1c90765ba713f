#pragma once
/// \file
/// Models of faults in the equation of a cylinder's side, and in how t is found from it.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// In the constant of the side's equation a radius, or its square, or nothing, stands for the 1 that is
/// subtracted. An answer for each such mistake, always in the same order.
[[nodiscard]] Answers side_constant_wrong(const Case& one, const Answer& exact);

/// The coefficient of t² in the side's equation has the direction's z in it. An answer for each of two ways
/// to find the discriminant.
[[nodiscard]] Answers side_with_z_of_direction(const Case& one, const Answer& exact);

/// The origin is divided by the radii, and the direction is not.
[[nodiscard]] Answers direction_not_divided_by_radii(const Case& one, const Answer& exact);

/// The side's t is a distance: the direction was made a unit vector, seen along the axis, in radii or in
/// lengths, and t is not divided by its length. An answer for each such mistake, always in the same order.
[[nodiscard]] Answers side_as_distance(const Case& one, const Answer& exact);

/// Half the chord of the side, seen along the axis, is not divided by the direction's length there, or by the
/// whole length. An answer for each of the two, always in the same order.
[[nodiscard]] Answers side_chord_undivided(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
