#pragma once
/// \file
/// Models of faults with where the ray starts and ends beside the shape.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// A ray that starts inside and ends there is said to hit beyond its end.
[[nodiscard]] Answers far_hit_beyond(const Case& one, const Answer& exact);
/// What lies wholly behind the origin is missed, however far back the interval begins.
[[nodiscard]] Answers behind_origin_missed(const Case& one, const Answer& exact);
/// Where the origin lies decides: from inside the farther hit is given, from outside the nearer one, be it
/// before t_min or not.
[[nodiscard]] Answers inside_decides(const Case& one, const Answer& exact);
/// What has an inside is hit from there at the origin, and what lies behind the origin is missed, whatever
/// t_min.
[[nodiscard]] Answers solid_from_origin(const Case& one, const Answer& exact);
/// Whether a hit lies outside the interval, and no farther than rounding puts it; else nothing.
[[nodiscard]] std::optional<bool> beyond_end_by_rounding(const Case& one, const Answer& got,
                                                         const Answer& exact);
/// @{ A surface is missed from an origin on that side of its plane: where the normal points, or not.
[[nodiscard]] Answers missed_from_front(const Case& one, const Answer& exact);
[[nodiscard]] Answers missed_from_back(const Case& one, const Answer& exact);
/// @}

}  // namespace rayproof::diagnosis
