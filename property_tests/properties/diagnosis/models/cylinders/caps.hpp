#pragma once
/// \file
/// Models of faults with the caps of a cylinder.

#include "properties/diagnosis/models/cylinder_parts.hpp"

namespace rayproof::diagnosis {

/// Whether a cap is hit is asked of the ray's origin in the place of its point on the cap.
[[nodiscard]] Answers caps_by_origin(const Case& one, const Answer& exact);
/// @{ Whether a cap is hit is asked, for both, of the point on the lower one's plane, or on the upper one's.
[[nodiscard]] Answers upper_cap_by_lower_point(const Case& one, const Answer& exact);
[[nodiscard]] Answers lower_cap_by_upper_point(const Case& one, const Answer& exact);
/// @}
/// The caps are hit where t of their planes has the other sign.
[[nodiscard]] Answers caps_at_opposite_t(const Case& one, const Answer& exact);
/// A ray that leaves through a cap does not hit it.
[[nodiscard]] Answers caps_from_outside_alone(const Case& one, const Answer& exact);
/// The upper cap is not looked at where the lower one is hit.
[[nodiscard]] Answers first_cap_alone(const Case& one, const Answer& exact);
/// A hit on the side is reported before one on a cap, even where that is nearer.
[[nodiscard]] Answers side_before_caps(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
