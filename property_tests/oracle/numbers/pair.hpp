#pragma once
/// \file
/// The oracle's third filter: sums of two doubles, exact or unknown.
///
/// Interval and Ball can never be certain of a 0, so every exact tangent would have to go through the exact
/// ring. Most tangents that people and generators come up with have few digits, and all their formulas are
/// exact in two doubles.

#include <cmath>
#include <limits>
#include <optional>

namespace rayproof::oracle {

/// high + low, exactly, with |low| at most half an ulp of high; unknown where `low` is NaN, and so is all
/// that is made of it.
struct Pair {
  double high = 0;
  double low = 0;

  Pair() = default;
  Pair(double exactly) : high(exactly) {}  // NOLINT: every double is a pair
  Pair(double h, double l) : high(h), low(l) {}

  [[nodiscard]] bool is_known() const { return std::isfinite(high) && std::isfinite(low); }
  [[nodiscard]] static Pair unknown() { return {0, std::numeric_limits<double>::quiet_NaN()}; }
};

/// x + y, the rounding error as the low part; exact whatever their sizes, and unknown on overflow.
[[nodiscard]] inline Pair sum_of(double x, double y) {
  const double sum = x + y;
  const double y_part = sum - x;
  return {sum, (x - (sum - y_part)) + (y - y_part)};
}

inline Pair operator-(const Pair& x) { return {-x.high, -x.low}; }

inline Pair operator+(const Pair& x, const Pair& y) {
  const Pair high = sum_of(x.high, y.high);
  const Pair low = sum_of(x.low, y.low);
  const Pair rest = sum_of(high.low, low.high);
  // What is left over must be nothing at all; NaN is not nothing.
  if (!(low.low == 0 && rest.low == 0)) return Pair::unknown();
  return sum_of(high.high, rest.high);
}

inline Pair operator-(const Pair& x, const Pair& y) { return x + (-y); }

/// Known only for numbers of one double each, far from underflow.
inline Pair operator*(const Pair& x, const Pair& y) {
  if (!(x.low == 0 && y.low == 0)) return Pair::unknown();
  const double product = x.high * y.high;
  const bool is_safe = std::abs(product) > 0x1p-900 || x.high == 0 || y.high == 0;
  return is_safe ? Pair{product, std::fma(x.high, y.high, -product)} : Pair::unknown();
}

/// The sign where the number is known; otherwise nothing.
[[nodiscard]] inline std::optional<int> certain_sign(const Pair& x) {
  if (!x.is_known()) return std::nullopt;
  return (x.high > 0) - (x.high < 0);
}

}  // namespace rayproof::oracle
