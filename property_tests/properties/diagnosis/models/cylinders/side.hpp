#pragma once
/// \file
/// Models of faults with the two roots of a cylinder's side, and with the ends of that.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// @{ Of the side's two roots one alone is looked at: the smaller, the larger, the first that the interval
/// admits. The caps are hit as they should be.
[[nodiscard]] Answers smaller_side_root_alone(const Case& one, const Answer& exact);
[[nodiscard]] Answers larger_side_root_alone(const Case& one, const Answer& exact);
[[nodiscard]] Answers first_side_root_alone(const Case& one, const Answer& exact);
/// @}
/// @{ Of a capped cylinder: the side goes on without end, though the caps are where they should be; the caps
/// are looked for where the side is not hit at all.
[[nodiscard]] Answers side_about_zero(const Case& one, const Answer& exact);
[[nodiscard]] Answers side_without_ends(const Case& one, const Answer& exact);
[[nodiscard]] Answers caps_where_side_missed(const Case& one, const Answer& exact);
/// @}

/// The side goes on without end upwards, or downwards, and the caps are where they should be.
[[nodiscard]] Answers side_goes_on(const Case& one, bool is_upwards);

/// Of the side's hits without end, in an open cylinder, only the first is compared with the height.
[[nodiscard]] Answers first_side_hit_decides(const Case& one, const Answer& exact);

/// The side's t is a distance: the direction was made a unit vector, seen along the axis, in radii or in
/// lengths, and t is not divided by its length. An answer for each such mistake, always in the same order.
[[nodiscard]] Answers side_as_distance(const Case& one, const Answer& exact);

/// The plane of the upper cap lies at another height: its square, twice it, half of it, 0; for all rays, or
/// for those alone that run upward. An answer for each such mistake, always in the same order.
[[nodiscard]] Answers upper_cap_elsewhere(const Case& one, const Answer& exact);

/// The height of a hit on the side is that of the point in the world, and must be the one in object space.
[[nodiscard]] Answers side_by_height_in_world(const Case& one, const Answer& exact);

/// In the constant of the side's equation a radius, or its square, or nothing, stands for the 1 that is
/// subtracted. An answer for each such mistake, always in the same order.
[[nodiscard]] Answers side_constant_wrong(const Case& one, const Answer& exact);

/// The coefficient of t² in the side's equation has the direction's z in it. An answer for each of two ways
/// to find the discriminant.
[[nodiscard]] Answers side_with_z_of_direction(const Case& one, const Answer& exact);

/// The origin is divided by the radii, and the direction is not.
[[nodiscard]] Answers direction_not_divided_by_radii(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
