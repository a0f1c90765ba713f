#pragma once
/// \file
/// The oracle's first filter: one double and a bound on its error. Decides nearly every verdict in a few
/// nanoseconds.

#include <cmath>

namespace rayproof::oracle {

/// Every real number within `radius` of `middle`; see Ball for overflow and underflow.
struct Interval {
  double middle, radius;

  Interval(double m = 0, double r = 0) : middle(m), radius(r) {}  // NOLINT: every double is an interval
};

/// A rounding is off by at most 2^-53 of the result; 2^-51 also covers the roundings of the radius itself.
inline constexpr double interval_rounding = 0x1p-51;
inline constexpr double interval_underflow = 0x1p-1060;

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
  return {product, radius + interval_rounding * (std::abs(product) + radius) + interval_underflow};
}

}  // namespace rayproof::oracle
