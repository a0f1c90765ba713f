#pragma once
/// \file
/// Models of faults in which of the hits of the whole line a ray is given.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// The nearest hit of the line lies outside the interval, and the farther one is not looked at.
[[nodiscard]] Answers first_hit_decides(const Case& one, const Answer& exact);
/// The last hit of the line is looked at alone.
[[nodiscard]] Answers last_hit_alone(const Case& one, const Answer& exact);
/// Of the hits of the line the one with the smaller |t| is looked at alone.
[[nodiscard]] Answers nearer_to_zero_decides(const Case& one, const Answer& exact);
/// What lies wholly before t_min is reported, in whole or by its first or last hit; other answers are right.
[[nodiscard]] Answers behind_is_hit(const Case& one, const Answer& exact);
/// A ray that starts inside is said to hit behind its beginning.
[[nodiscard]] Answers near_hit_behind(const Case& one, const Answer& exact);
/// All hits of the line are reported where one of them lies in the interval.
[[nodiscard]] Answers one_hit_admits_all(const Case& one, const Answer& exact);
/// Every hit of the line must lie in the interval, else none is reported.
[[nodiscard]] Answers all_hits_or_none(const Case& one, const Answer& exact);
/// Where the interval begins or ends between two hits, its ends are reported as hits.
[[nodiscard]] Answers clipped_to_interval(const Case& one, const Answer& exact);
/// The same of its beginning alone.
[[nodiscard]] Answers clipped_at_t_min(const Case& one, const Answer& exact);
/// @{ What lies wholly before t_min is a hit at t_min; what lies wholly beyond t_max is one at t_max.
[[nodiscard]] Answers behind_at_t_min(const Case& one, const Answer& exact);
[[nodiscard]] Answers beyond_at_t_max(const Case& one, const Answer& exact);
/// @}
/// A ray that starts inside and ends there is said to hit beyond its end.
[[nodiscard]] Answers far_hit_beyond(const Case& one, const Answer& exact);
/// The far hit is reported beyond t_max wherever the near one lies before it.
[[nodiscard]] Answers far_hit_not_compared(const Case& one, const Answer& exact);
/// What lies wholly behind the origin is missed, however far back the interval begins.
[[nodiscard]] Answers behind_origin_missed(const Case& one, const Answer& exact);
/// Where the origin lies decides: from inside the farther hit is given, from outside the nearer one, be it
/// before t_min or not.
[[nodiscard]] Answers inside_decides(const Case& one, const Answer& exact);
/// What has an inside is hit from there at the origin, and what lies behind the origin is missed, whatever
/// t_min.
[[nodiscard]] Answers solid_from_origin(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
