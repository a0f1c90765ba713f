#pragma once
/// \file
/// Models of a determinant that is compared with a small number without its magnitude: what has it negative
/// is missed, and what has it small, too.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// A surface is missed where `sign` n·d is below a power of ten from 1e-2 to 1e-15. An answer for each.
[[nodiscard]] Answers slope_without_abs(const Case& one, const Answer& exact, double sign);
template <int sign>
[[nodiscard]] Answers slope_without_abs(const Case& one, const Answer& exact) {
  return slope_without_abs(one, exact, sign);
}
/// Whether it is small and has the right sign: that a side is missed would be less.
[[nodiscard]] bool has_small_slope(const Case& one, double sign);
template <int sign>
[[nodiscard]] bool has_small_slope(const Case& one, const Answer& /*exact*/) {
  return has_small_slope(one, sign);
}

/// The same of a parallelepiped's volume, negative where its edges are left-handed.
[[nodiscard]] Answers volume_without_abs(const Case& one, const Answer& exact);
[[nodiscard]] bool has_small_volume(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
