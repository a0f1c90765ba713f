#pragma once
/// \file
/// The oracle's exact numbers: a ring without rounding, and numbers of any size to read its values by.

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

#include "oracle/numbers/ring.hpp"

namespace rayproof::oracle {

/// m·2^e with a long double m of any size that products of two do not take out of its range (or 0): sizes
/// that overflow a double, to 2^-60 or better relative precision.
class Scaled {
 public:
  [[gnu::always_inline]] Scaled(long double mantissa = 0, long exponent = 0)  // NOLINT: a number is a Scaled
      : mantissa_(mantissa), exponent_(mantissa == 0 ? 0 : exponent) {
    const long double size = std::abs(mantissa_);
    if (!(size > 0x1p-4000L && size < 0x1p+4000L) && size != 0) normalise();
  }

  /// The nearest long double; overflows to infinity and underflows to 0.
  [[nodiscard]] long double value() const {
    if (exponent_ == 0) return mantissa_;
    const Scaled x = normal();
    return std::ldexp(x.mantissa_, static_cast<int>(std::clamp(x.exponent_, -20000L, 20000L)));
  }
  /// e with 2^(e-1) <= |x| < 2^e.
  [[nodiscard]] long exponent() const { return normal().exponent_; }
  [[nodiscard]] int sign() const { return (mantissa_ > 0) - (mantissa_ < 0); }

  [[gnu::always_inline]] friend Scaled operator-(const Scaled& x) { return {-x.mantissa_, x.exponent_}; }
  [[gnu::always_inline]] friend Scaled operator*(const Scaled& x, const Scaled& y) {
    return {x.mantissa_ * y.mantissa_, x.exponent_ + y.exponent_};
  }
  [[gnu::always_inline]] friend Scaled operator/(const Scaled& x, const Scaled& y) {
    return {x.mantissa_ / y.mantissa_, x.exponent_ - y.exponent_};
  }
  [[gnu::always_inline]] friend Scaled operator+(const Scaled& x, const Scaled& y) {
    if (x.exponent_ == y.exponent_) return {x.mantissa_ + y.mantissa_, x.exponent_};
    if (x.mantissa_ == 0 || y.mantissa_ == 0) return x.mantissa_ == 0 ? y : x;
    return sum_of_normals(x.normal(), y.normal());
  }
  [[gnu::always_inline]] friend Scaled operator-(const Scaled& x, const Scaled& y) { return x + (-y); }
  [[gnu::always_inline]] friend bool operator<(const Scaled& x, const Scaled& y) {
    return (x - y).sign() < 0;
  }
  friend Scaled sqrt(const Scaled& x) {
    const bool odd = x.exponent_ % 2 != 0;
    return {std::sqrt(odd ? 2 * x.mantissa_ : x.mantissa_), (x.exponent_ - (odd ? 1 : 0)) / 2};
  }
  friend Scaled abs(const Scaled& x) { return {std::abs(x.mantissa_), x.exponent_}; }

 private:
  /// Makes m one in [1/2, 1); of 0 the exponent is 0, too.
  [[gnu::noinline]] void normalise() {
    int shift = 0;
    mantissa_ = std::frexp(mantissa_, &shift);
    exponent_ = mantissa_ == 0 ? 0 : exponent_ + shift;
  }
  [[nodiscard]] Scaled normal() const {
    Scaled x = *this;
    x.normalise();
    return x;
  }
  [[gnu::noinline]] static Scaled sum_of_normals(const Scaled& x, const Scaled& y) {
    if (x.exponent_ < y.exponent_) return sum_of_normals(y, x);
    const long apart = y.exponent_ - x.exponent_;
    return {x.mantissa_ + (apart < -200 ? 0 : std::ldexp(y.mantissa_, static_cast<int>(apart))), x.exponent_};
  }

  long double mantissa_;
  long exponent_;
};

/// What sizes and errors of an R are read as. Those of estimates alone are long doubles: whoever asks for
/// them sees to it that none is out of range.
template <class R>
using SizeOf = std::conditional_t<std::is_same_v<R, Estimate>, long double, Scaled>;

[[nodiscard]] inline int sign(const Scaled& x) { return x.sign(); }
[[nodiscard]] inline int sign(long double x) { return (x > 0) - (x < 0); }

/// error / unit; an error of 0 is 0 in units of 0, too.
template <class Size>
[[nodiscard]] Size ratio(const Size& error, const Size& unit) {
  return sign(error) == 0 ? error : error / unit;
}

/// The sign of an exact number: -1, 0 or 1. Notes a doubt of an estimate that may be 0.
[[nodiscard]] inline int sign(const Estimate& x) {
  const auto known = certain_sign(x);
  if (!known) Doubt::note();
  return known.value_or(1);
}
[[nodiscard]] inline int sign(const Ring& x) {
  return x.is_exact() ? static_cast<int>(x.exact().sign()) : sign(x.estimate());
}

/// The value of an estimate that is good to one part in 1/`share`; notes a doubt of others.
[[nodiscard]] inline long double approximate(const Estimate& x, double share = 0x1p-62) {
  const double room = share * std::abs(x.high);
  if (!(x.radius() <= room && std::isfinite(room))) Doubt::note();
  return static_cast<long double>(x.high) + x.low;
}

/// The value of an exact number of any size to one part in 2^62.
[[nodiscard]] inline Scaled approximate(const Exact& x) {
  if (x.is_zero()) return {};
  const double leading = x.to_double();
  const double size = std::abs(leading);
  if (!(size > 0x1p-900 && size < 0x1p+1000)) {
    const int shift = size < 1 ? 900 : -900;
    return approximate(x * Exact(std::ldexp(1.0, shift))) * Scaled(1, -shift);
  }
  return Scaled(static_cast<long double>(leading) + (x - Exact(leading)).to_double());
}
[[nodiscard]] inline Scaled approximate(const Ring& x) {
  return x.is_exact() ? approximate(x.exact()) : approximate(x.estimate());
}
/// The same of an error, which need not be known better than to one part in 2^30.
[[nodiscard]] inline long double roughly(const Estimate& x) { return approximate(x, 0x1p-30); }
[[nodiscard]] inline Scaled roughly(const Ring& x) {
  return x.is_exact() ? approximate(x.exact()) : roughly(x.estimate());
}

/// What formulas over any ring ask of a number; for the filters see filters.hpp. Values are read as numbers
/// of any size.
[[nodiscard]] inline Scaled read(const Ring& x) { return approximate(x); }
[[nodiscard]] inline Scaled read(const Scaled& x) { return x; }
[[nodiscard]] inline double uncertainty(const Ring&) { return 0; }
[[nodiscard]] inline std::optional<int> certain_sign(const Ring& x) { return sign(x); }

/// What was read as a double.
[[nodiscard]] inline double value(double x) { return x; }
[[nodiscard]] inline double value(long double x) { return static_cast<double>(x); }
[[nodiscard]] inline double value(const Scaled& x) { return static_cast<double>(x.value()); }

}  // namespace rayproof::oracle
