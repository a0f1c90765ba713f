#pragma once
/// \file
/// The oracle's exact numbers: a ring without rounding, and numbers of any size to read its values by.

#include <CGAL/Mpzf.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rayproof::oracle {

/// Dyadic numbers with exact + - * and sign; no division. Every finite double is one, subnormals included.
using Ring = CGAL::Mpzf;

/// m·2^e with a long double m in [1/2, 1) (or 0): sizes that overflow a double, to 2^-60 or better relative
/// precision.
class Scaled {
 public:
  Scaled(long double mantissa = 0, long exponent = 0) {  // NOLINT: a number is a Scaled
    int shift = 0;
    mantissa_ = std::frexp(mantissa, &shift);
    exponent_ = mantissa_ == 0 ? 0 : exponent + shift;
  }

  /// The nearest long double; overflows to infinity and underflows to 0.
  [[nodiscard]] long double value() const {
    return std::ldexp(mantissa_, static_cast<int>(std::clamp(exponent_, -20000L, 20000L)));
  }
  /// e with 2^(e-1) <= |x| < 2^e.
  [[nodiscard]] long exponent() const { return exponent_; }
  [[nodiscard]] int sign() const { return (mantissa_ > 0) - (mantissa_ < 0); }

  friend Scaled operator-(const Scaled& x) { return {-x.mantissa_, x.exponent_}; }
  friend Scaled operator*(const Scaled& x, const Scaled& y) {
    return {x.mantissa_ * y.mantissa_, x.exponent_ + y.exponent_};
  }
  friend Scaled operator/(const Scaled& x, const Scaled& y) {
    return {x.mantissa_ / y.mantissa_, x.exponent_ - y.exponent_};
  }
  friend Scaled operator+(const Scaled& x, const Scaled& y) {
    if (x.mantissa_ == 0 || y.mantissa_ == 0) return x.mantissa_ == 0 ? y : x;
    if (x.exponent_ < y.exponent_) return y + x;
    const long apart = y.exponent_ - x.exponent_;
    return {x.mantissa_ + (apart < -200 ? 0 : std::ldexp(y.mantissa_, static_cast<int>(apart))), x.exponent_};
  }
  friend Scaled operator-(const Scaled& x, const Scaled& y) { return x + (-y); }
  friend bool operator<(const Scaled& x, const Scaled& y) { return (x - y).sign() < 0; }
  friend Scaled sqrt(const Scaled& x) {
    const bool odd = x.exponent_ % 2 != 0;
    return {std::sqrt(odd ? 2 * x.mantissa_ : x.mantissa_), (x.exponent_ - (odd ? 1 : 0)) / 2};
  }
  friend Scaled abs(const Scaled& x) { return {std::abs(x.mantissa_), x.exponent_}; }

 private:
  long double mantissa_;
  long exponent_;
};

/// error / unit; an error of 0 is 0 in units of 0, too.
[[nodiscard]] inline Scaled ratio(const Scaled& error, const Scaled& unit) {
  return error.sign() == 0 ? error : error / unit;
}

/// The sign of an exact number: -1, 0 or 1.
[[nodiscard]] inline int sign(const Ring& x) { return static_cast<int>(x.sign()); }

/// The value of an exact number of any size to one part in 2^62.
[[nodiscard]] inline Scaled approximate(const Ring& x) {
  if (x.is_zero()) return {};
  const double leading = x.to_double();
  const double size = std::abs(leading);
  if (!(size > 0x1p-900 && size < 0x1p+1000)) {
    const int shift = size < 1 ? 900 : -900;
    return approximate(x * Ring(std::ldexp(1.0, shift))) * Scaled(1, -shift);
  }
  return Scaled(static_cast<long double>(leading) + (x - Ring(leading)).to_double());
}

/// What formulas over any ring ask of a number; for the filters see filters.hpp. Values are read as numbers
/// of any size.
[[nodiscard]] inline Scaled read(const Ring& x) { return approximate(x); }
[[nodiscard]] inline Scaled read(const Scaled& x) { return x; }
[[nodiscard]] inline double uncertainty(const Ring&) { return 0; }
[[nodiscard]] inline std::optional<int> certain_sign(const Ring& x) { return sign(x); }

/// What was read as a double.
[[nodiscard]] inline double value(double x) { return x; }
[[nodiscard]] inline double value(const Scaled& x) { return static_cast<double>(x.value()); }

}  // namespace rayproof::oracle
