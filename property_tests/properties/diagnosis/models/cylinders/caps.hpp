#pragma once
/// \file
/// Models of faults with the caps of a cylinder.

#include "properties/diagnosis/models/cylinder_parts.hpp"

namespace rayproof::diagnosis {

/// @{ The caps have another outline than the side: a circle of radius rx, of radius ry, of the larger or
/// smaller one, or of the root of rx.
[[nodiscard]] Answers caps_of_larger_radius(const Case& one, const Answer& exact);
[[nodiscard]] Answers caps_of_smaller_radius(const Case& one, const Answer& exact);
[[nodiscard]] Answers caps_of_radius_rx(const Case& one, const Answer& exact);
[[nodiscard]] Answers caps_of_radius_ry(const Case& one, const Answer& exact);
[[nodiscard]] Answers caps_of_rooted_radius(const Case& one, const Answer& exact);
/// A diamond between the ends of the ellipse's axes.
[[nodiscard]] Answers caps_as_diamonds(const Case& one, const Answer& exact);
/// @}
/// Whether a cap is hit is asked of the ray's origin in the place of its point on the cap.
[[nodiscard]] Answers caps_by_origin(const Case& one, const Answer& exact);
/// @{ Whether a cap is hit is asked, for both, of the point on the lower one's plane, or on the upper one's.
[[nodiscard]] Answers upper_cap_by_lower_point(const Case& one, const Answer& exact);
[[nodiscard]] Answers lower_cap_by_upper_point(const Case& one, const Answer& exact);
/// @}
/// @{ The caps are hit outside of their outline; where t of their planes has the other sign.
[[nodiscard]] Answers caps_outside_outline(const Case& one, const Answer& exact);
[[nodiscard]] Answers caps_at_opposite_t(const Case& one, const Answer& exact);
/// @}
/// A hit on a cap may be left out near its rim, or the solid be missed there.
[[nodiscard]] Answers cap_rim_missed(const Case& one, const Answer& exact);
/// Whether a hit on a cap is farther from its rim than rounding can say.
[[nodiscard]] bool passes_cap_near_rim(const Case& one, const Answer& exact);
/// A ray that leaves through a cap does not hit it.
[[nodiscard]] Answers caps_from_outside_alone(const Case& one, const Answer& exact);
/// The upper cap is not looked at where the lower one is hit.
[[nodiscard]] Answers first_cap_alone(const Case& one, const Answer& exact);
/// A hit on the side is reported before one on a cap, even where that is nearer.
[[nodiscard]] Answers side_before_caps(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
