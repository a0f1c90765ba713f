#pragma once
/// \file
/// The oracle's filter: double-double numbers that carry a bound on their own error.
///
/// A formula of the oracle is written once over its ring. Run over balls it costs tens of nanoseconds and
/// knows when it can't decide; then the same formula runs over the exact ring. This code is the oracle's own
/// on purpose: it shares no line with the arithmetics it judges.

#include <cmath>

namespace rayproof::oracle {

/// Every real number within `radius` of high + low. An overflow makes the radius infinite or NaN, so that no
/// sign is certain; what underflow can lose is added to every radius.
struct Ball {
  double high = 0;
  double low = 0;
  double radius = 0;

  Ball() = default;
  Ball(double exactly) : high(exactly) {}  // NOLINT: every double is a ball
  Ball(double h, double l, double r) : high(h), low(l), radius(r) {}
};

/// What the operations may lose to underflow, and their relative rounding error with room to spare: an
/// addition of double-doubles is off by less than 2^-103 of |x| + |y|, a product by less than 2^-100 of |xy|.
inline constexpr double ball_underflow = 0x1p-1060;
inline constexpr double ball_rounding = 0x1p-100;

/// x + y where |x| >= |y| or x = 0, its rounding error as the low part.
[[nodiscard]] inline Ball normalised(double x, double y, double radius) {
  const double sum = x + y;
  return {sum, y - (sum - x), radius};
}

inline Ball operator-(const Ball& x) { return {-x.high, -x.low, x.radius}; }

inline Ball operator+(const Ball& x, const Ball& y) {
  const double sum = x.high + y.high;
  const double y_part = sum - x.high;
  const double rest = (x.high - (sum - y_part)) + (y.high - y_part);
  const double radius =
      x.radius + y.radius + ball_rounding * (std::abs(x.high) + std::abs(y.high)) + ball_underflow;
  return normalised(sum, rest + (x.low + y.low), radius);
}

inline Ball operator-(const Ball& x, const Ball& y) { return x + (-y); }

inline Ball operator*(const Ball& x, const Ball& y) {
  const double product = x.high * y.high;
  const double rest = std::fma(x.high, y.high, -product);
  const double size_x = std::abs(x.high) + x.radius;
  const double size_y = std::abs(y.high) + y.radius;
  const double radius = size_x * y.radius + size_y * x.radius;
  // The factor outweighs the roundings of this very line; size_x·size_y outweighs |product|.
  return normalised(product, rest + (x.high * y.low + x.low * y.high),
                    (1 + 0x1p-40) * radius + ball_rounding * size_x * size_y + ball_underflow);
}

}  // namespace rayproof::oracle
