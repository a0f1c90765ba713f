#pragma once
/// \file
/// Models of faults with where the ray starts and ends beside the shape.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// A ray that starts inside and ends there is said to hit beyond its end.
[[nodiscard]] Answers far_hit_beyond(const Case& one, const Answer& exact);
/// What lies wholly behind the origin is missed, however far back the interval begins.
[[nodiscard]] Answers behind_origin_missed(const Case& one, const Answer& exact);
/// @{ A surface is missed from an origin on that side of its plane: where the normal points, or not.
[[nodiscard]] Answers missed_from_front(const Case& one, const Answer& exact);
[[nodiscard]] Answers missed_from_back(const Case& one, const Answer& exact);
/// @}

}  // namespace rayproof::diagnosis
