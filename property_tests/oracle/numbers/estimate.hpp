#pragma once
/// \file
/// The filter of most digits: a number in two doubles, and a bound on its error that costs little to keep.

#include <algorithm>

#include "oracle/numbers/filters.hpp"

namespace rayproof::oracle {

/// high + low, off by `steps`·2^-99·size at most, where `size` is what the number would be if all terms that
/// it is made of had one sign.
///
/// An addition of double-doubles is off by less than 2^-103 of |x| + |y|, a product by less than 2^-100 of
/// |xy|; twice that is left for the roundings of `size` and the products of errors. An overflow makes `size`
/// infinite or NaN, so that nothing is certain; what underflow can lose is covered by `least_size`.
struct Estimate {
  double high, low, size;
  int steps;

  Estimate(double x = 0) : high(x), low(0), size(std::abs(x)), steps(0) {}  // NOLINT: every double is one
  /// x + y where |x| >= |y| or x = 0.
  Estimate(double x, double y, double all, int made_in) : size(all), steps(made_in) {
    high = x + y;
    low = y - (high - x);
  }

  /// Nothing is lost of a pair.
  explicit Estimate(const Pair& x) : high(x.high), low(x.low), size(std::abs(x.high)), steps(0) {}

  [[nodiscard]] bool is_one() const { return steps == 0 && high == 1 && low == 0; }
  [[nodiscard]] double radius() const { return steps * 0x1p-99 * size; }
};

/// 2^-99 of it is more than the few subnormals that a product may lose.
inline constexpr double least_size = 0x1p-960;

[[gnu::always_inline]] inline Estimate operator-(const Estimate& x) {
  Estimate negative = x;
  negative.high = -x.high;
  negative.low = -x.low;
  return negative;
}

[[gnu::always_inline]] inline Estimate operator+(const Estimate& x, const Estimate& y) {
  const Pair sum = sum_of(x.high, y.high);
  return {sum.high, sum.low + (x.low + y.low), x.size + y.size, std::max(x.steps, y.steps) + 1};
}

[[gnu::always_inline]] inline Estimate operator-(const Estimate& x, const Estimate& y) { return x + (-y); }

[[gnu::always_inline]] inline Estimate operator*(const Estimate& x, const Estimate& y) {
  if (x.is_one()) return y;  // the weight of what is no quotient
  if (y.is_one()) return x;
  const Pair product = product_of(x.high, y.high);
  return {product.high, product.low + (x.high * y.low + x.low * y.high), x.size * y.size + least_size,
          x.steps + y.steps + 1};
}

/// What formulas over any ring ask of a number (filters.hpp).
[[nodiscard]] inline double read(const Estimate& x) { return x.high; }
[[nodiscard]] inline double uncertainty(const Estimate& x) { return x.radius(); }

/// The sign of an estimate that is clear of 0; of 0 itself where nothing has been computed.
[[nodiscard]] inline std::optional<int> certain_sign(const Estimate& x) {
  const double radius = x.radius();
  if (std::abs(x.high) > 1.001 * radius) return x.high > 0 ? 1 : -1;
  return x.steps == 0 ? std::optional((x.high > 0) - (x.high < 0)) : std::nullopt;
}

}  // namespace rayproof::oracle
