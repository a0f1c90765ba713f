#pragma once
/// \file
/// Models of a solid taken for the stretch of t inside it, cut off where the ray or the interval ends.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// The stretch begins at t = 0 at the earliest, wherever the interval begins: a ray that starts inside hits
/// there, and what lies behind the origin is missed. An answer for the smallest positive number in the place
/// of 0, and one for 0.
[[nodiscard]] Answers cut_off_at_zero(const Case& one, const Answer& exact);
/// It ends at t_max at the latest: a hit beyond that is reported there. Where it begins is not changed.
[[nodiscard]] Answers exit_at_t_max(const Case& one, const Answer& exact);
/// A ray that starts inside is said to hit at t = 0 alone.
[[nodiscard]] Answers zero_from_inside(const Case& one, const Answer& exact);
/// @{ Whether the hit is at t = -1, the number that stands for a miss: of every ray; of one that misses.
[[nodiscard]] std::optional<bool> is_at_minus_one(const Case& one, const Answer& got, const Answer& exact);
[[nodiscard]] std::optional<bool> misses_at_minus_one(const Case& one, const Answer& got,
                                                      const Answer& exact);
/// @}

}  // namespace rayproof::diagnosis
