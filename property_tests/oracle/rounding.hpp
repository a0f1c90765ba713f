#pragma once
/// \file
/// Correct rounding of an exactly comparable number.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "case/case.hpp"
#include "oracle/root.hpp"

namespace rayproof::oracle {

/// `root` rounded to nearest, ties to even, in the case's precision; infinite where it overflows.
[[nodiscard]] double round_correctly(const ExactRoot& root, Precision precision);

/// The unit in the last place of a number of this size in the precision: the gap to the next larger
/// magnitude, never less than the smallest subnormal.
[[nodiscard]] inline double ulp_of(double magnitude, Precision precision) {
  const bool narrow = precision == Precision::float32;
  const int digits = narrow ? 24 : 53;
  const int smallest = narrow ? -149 : -1074;
  if (magnitude == 0) return std::ldexp(1.0, smallest);
  return std::ldexp(1.0, std::max(std::ilogb(magnitude) - digits + 1, smallest));
}

/// ε, the unit roundoff of the precision.
[[nodiscard]] inline double unit_roundoff(Precision precision) {
  return precision == Precision::float32 ? 0x1p-24 : 0x1p-53;
}

}  // namespace rayproof::oracle
