#pragma once
/// \file
/// Models of faults with the ends of a cylinder, and of rays along its axis.

#include <cmath>

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// @{ A capped cylinder without its cap at z = 0, or at z = height.
[[nodiscard]] Answers no_lower_cap(const Case& one, const Answer& exact);
[[nodiscard]] Answers no_upper_cap(const Case& one, const Answer& exact);
/// @}

/// @{ A cap is its whole plane; the rectangle round the ellipse.
[[nodiscard]] Answers caps_without_rim(const Case& one, const Answer& exact);
[[nodiscard]] Answers caps_as_rectangles(const Case& one, const Answer& exact);
/// @}

/// @{ A cylinder without end upwards, or downwards.
[[nodiscard]] Answers upper_end_not_tested(const Case& one, const Answer& exact);
[[nodiscard]] Answers lower_end_not_tested(const Case& one, const Answer& exact);
/// @}

/// One of the ends is tested for rays that go up alone, or down alone. An answer for each such mistake,
/// always in the same order.
[[nodiscard]] Answers end_tested_one_way(const Case& one, const Answer& exact);

/// @{ Hits of an open cylinder exactly at an end, or at either, are left out.
[[nodiscard]] Answers without_low_rim(const Case& one, const Answer& exact);
[[nodiscard]] Answers without_high_rim(const Case& one, const Answer& exact);
[[nodiscard]] Answers without_rims(const Case& one, const Answer& exact);
/// @}

/// A cylinder without end or caps.
[[nodiscard]] std::vector<Case> endless_cylinder(const Case& one);

/// The object moved along its own z axis.
void lift(RayQuestion& asked, double by);

/// @{ A ray along the axis is missed, or one that starts between the planes of both ends alone.
[[nodiscard]] Answers missed_along_axis(const Case& one, const Answer& exact);
[[nodiscard]] Answers missed_along_axis_inside(const Case& one, const Answer& exact);
/// @}

/// The radius rx stands for the height: of the whole cylinder, or of its side alone. An answer for each.
[[nodiscard]] Answers radius_as_height(const Case& one, const Answer& exact);

/// A ray at a right angle to the axis is missed.
[[nodiscard]] Answers missed_across_axis(const Case& one, const Answer& exact);

/// A capped cylinder of no height, which is an ellipse, is missed.
[[nodiscard]] Answers no_height_is_missed(const Case& one, const Answer& exact);

/// A ray in the side of a capped cylinder, which runs along the axis from rim to rim, is missed.
[[nodiscard]] Answers missed_along_side(const Case& one, const Answer& exact);

/// The side is missed by rays nearly along the axis: where dx² + dy², in radii or not, is below a limit.
[[nodiscard]] Answers side_missed_along(const Case& one, double least);
template <int power>
[[nodiscard]] Answers side_missed_along(const Case& one, const Answer& /*exact*/) {
  return side_missed_along(one, std::pow(10.0, power));
}

}  // namespace rayproof::diagnosis
