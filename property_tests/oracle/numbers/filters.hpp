#pragma once
/// \file
/// The oracle's filters: numbers in one double or two, which know when they can't decide.
///
/// A formula of the oracle is written once over its ring. Run over intervals it costs a few nanoseconds and
/// decides nearly every verdict; estimates (estimate.hpp) take tens, and cancel less. Neither can ever be
/// certain of a 0, so every exact tangent would have to go through the exact ring; but most tangents that
/// people and generators come up with have few digits, and all their formulas are exact in pairs. This code
/// is the oracle's own on purpose: it shares no line with the arithmetics it judges.

#include <cmath>
#include <limits>
#include <optional>

namespace rayproof::oracle {

/// What an operation may lose to underflow.
inline constexpr double filter_underflow = 0x1p-1060;

/// Every real number within `radius` of `middle`. An overflow makes the radius infinite or NaN, so that
/// no sign is certain; what underflow can lose is added to every radius.
struct Interval {
  double middle, radius;

  Interval(double m = 0, double r = 0) : middle(m), radius(r) {}  // NOLINT: every double is an interval
};

/// A rounding is off by at most 2^-53 of the result; 2^-51 also covers the roundings of the radius itself.
inline constexpr double interval_rounding = 0x1p-51;

inline Interval operator-(const Interval& x) { return {-x.middle, x.radius}; }

inline Interval operator+(const Interval& x, const Interval& y) {
  const double sum = x.middle + y.middle;
  const double radius = x.radius + y.radius;
  return {sum, radius + interval_rounding * (std::abs(sum) + radius)};
}

inline Interval operator-(const Interval& x, const Interval& y) { return x + (-y); }

inline Interval operator*(const Interval& x, const Interval& y) {
  const double product = x.middle * y.middle;
  const double radius = (std::abs(x.middle) + x.radius) * y.radius + std::abs(y.middle) * x.radius;
  return {product, radius + interval_rounding * (std::abs(product) + radius) + filter_underflow};
}

/// high + low, exactly, with |low| at most half an ulp of high; unknown where `low` is NaN, and so is all
/// that is made of it.
struct Pair {
  double high, low;

  Pair(double h = 0, double l = 0) : high(h), low(l) {}  // NOLINT: every double is a pair

  [[nodiscard]] bool is_known() const { return std::isfinite(high) && std::isfinite(low); }
  [[nodiscard]] static Pair unknown() { return {0, std::numeric_limits<double>::quiet_NaN()}; }
};

/// x + y, the rounding error as the low part; exact whatever their sizes, and unknown on overflow.
[[nodiscard]] inline Pair sum_of(double x, double y) {
  const double sum = x + y;
  const double y_part = sum - x;
  return {sum, (x - (sum - y_part)) + (y - y_part)};
}
/// x·y, the rounding error as the low part; exact but for underflow.
[[nodiscard]] inline Pair product_of(double x, double y) {
  const double product = x * y;
  return {product, std::fma(x, y, -product)};
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
  const Pair product = product_of(x.high, y.high);
  const bool is_safe = std::abs(product.high) > 0x1p-900 || x.high == 0 || y.high == 0;
  return is_safe ? product : Pair::unknown();
}

/// The double to read a value by; the filters are used only where doubles do not overflow.
[[nodiscard]] inline double read(const Interval& x) { return x.middle; }
[[nodiscard]] inline double read(const Pair& x) { return x.high; }

/// How far the true value of `x` may lie from read(x).
[[nodiscard]] inline double uncertainty(const Interval& x) { return x.radius; }
[[nodiscard]] inline double uncertainty(const Pair&) { return 0; }

/// The sign of an interval that does not touch 0; otherwise nothing.
[[nodiscard]] inline std::optional<int> certain_sign(const Interval& x) {
  if (std::abs(read(x)) > 1.001 * x.radius) return read(x) > 0 ? 1 : -1;
  return std::nullopt;
}
/// The sign of a pair that is known; otherwise nothing.
[[nodiscard]] inline std::optional<int> certain_sign(const Pair& x) {
  if (!x.is_known()) return std::nullopt;
  return (x.high > 0) - (x.high < 0);
}

}  // namespace rayproof::oracle
