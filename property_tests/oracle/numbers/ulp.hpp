#pragma once
/// \file
/// The size of a number's last place.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "case/case.hpp"

namespace rayproof::oracle {

/// The exponent e of a positive number, 2^e <= x < 2^(e+1), read from its bits; -1023 for all subnormals.
[[nodiscard]] inline int exponent_of(double x) {
  return static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52) - 1023;
}

/// The unit in the last place of a number of this size in the precision: the gap to the next larger
/// magnitude, never less than the smallest subnormal.
[[nodiscard]] inline double ulp_of(double number, Precision precision) {
  const bool narrow = precision == Precision::float32;
  const int exponent = std::max(exponent_of(std::abs(number)) - (narrow ? 23 : 52), narrow ? -149 : -1074);
  if (exponent < -1022) return std::ldexp(1.0, exponent);
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

/// How far a claimed number is from an exact one that is a number of the precision, in ulps of the exact one;
/// of infinity every other number is infinitely far.
[[nodiscard]] inline double error_in_ulps(double exact, double claimed, Precision precision) {
  if (exact == claimed) return 0;
  if (!std::isfinite(exact) || !std::isfinite(claimed)) return HUGE_VAL;
  return std::abs(claimed - exact) / ulp_of(exact, precision);
}

}  // namespace rayproof::oracle
