#pragma once
/// \file
/// Models of faults with the two roots of a cylinder's side, and with the ends of that.

#include "properties/diagnosis/models/curved/root_formula.hpp"

namespace rayproof::diagnosis {

/// The roots in a list; none where there are none.
[[nodiscard]] std::vector<double> listed(const FoundRoots& roots);
/// Those of the side without end, ascending; none where the line passes it by, or of another shape.
[[nodiscard]] std::vector<double> roots_of_side(const Case& one);

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
/// The side is looked for where no cap is hit.
[[nodiscard]] Answers side_where_caps_missed(const Case& one, const Answer& exact);
/// @}

/// The side goes on without end upwards, or downwards, and the caps are where they should be.
[[nodiscard]] Answers side_goes_on(const Case& one, bool is_upwards);

/// |z| <= height is asked of the side: it goes on below z = 0 as far as above.
[[nodiscard]] Answers side_mirrored(const Case& one, const Answer& exact);
/// Of the side's hits without end, in an open cylinder, only the first is compared with the height.
[[nodiscard]] Answers first_side_hit_decides(const Case& one, const Answer& exact);

/// Of the side's two hits without end the height of the nearer one decides for both.
[[nodiscard]] Answers near_height_decides(const Case& one, const Answer& exact);

/// The plane of the upper cap lies at another height: its square, twice it, half of it, 0; for all rays, or
/// for those alone that run upward. An answer for each such mistake, always in the same order.
[[nodiscard]] Answers upper_cap_elsewhere(const Case& one, const Answer& exact);

/// The height of a hit on the side is that of the point in the world, and must be the one in object space.
[[nodiscard]] Answers side_by_height_in_world(const Case& one, const Answer& exact);
/// It is computed from the origin in object space and the direction in the world, or the other way round. An
/// answer for each.
[[nodiscard]] Answers side_by_mixed_height(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
