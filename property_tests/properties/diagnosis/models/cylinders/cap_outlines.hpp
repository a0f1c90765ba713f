#pragma once
/// \file
/// Models of faults with the outline of a cylinder's caps.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// @{ The caps have another outline than the side: a circle of radius rx, of radius ry, of the larger or
/// smaller one, or of the root of rx.
[[nodiscard]] Answers caps_of_larger_radius(const Case& one, const Answer& exact);
[[nodiscard]] Answers caps_of_smaller_radius(const Case& one, const Answer& exact);
[[nodiscard]] Answers caps_of_radius_rx(const Case& one, const Answer& exact);
[[nodiscard]] Answers caps_of_radius_ry(const Case& one, const Answer& exact);
[[nodiscard]] Answers caps_of_rooted_radius(const Case& one, const Answer& exact);
/// An ellipse with the radii exchanged.
[[nodiscard]] Answers caps_of_exchanged_radii(const Case& one, const Answer& exact);
/// A diamond between the ends of the ellipse's axes.
[[nodiscard]] Answers caps_as_diamonds(const Case& one, const Answer& exact);
/// @}
/// The caps are hit outside of their outline.
[[nodiscard]] Answers caps_outside_outline(const Case& one, const Answer& exact);
/// A hit on a cap may be left out near its rim, or the solid be missed there.
[[nodiscard]] Answers cap_rim_missed(const Case& one, const Answer& exact);
/// Whether a hit on a cap is farther from its rim than rounding can say.
[[nodiscard]] bool passes_cap_near_rim(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
