#pragma once
/// \file
/// The arithmetic that stands in for real numbers in walkthroughs and pictures.

#include <compare>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

namespace rayproof::viz {

/// 320 significant bits (267 more than double) and an exponent range that no product of doubles leaves; with
/// infinities and NaN; every operation rounds once, to nearest. A number of MPFR, whose header stays in
/// shadow.cpp.
class Shadow {
 public:
  Shadow() : Shadow(0.0) {}
  /// Exact; whole numbers up to 2^53.
  template <class Number>
  requires std::is_arithmetic_v<Number> Shadow(Number value) : Shadow(Exactly{static_cast<double>(value)}) {}

  /// The nearest one, halfway to even.
  explicit operator double() const;
  explicit operator float() const;

  friend Shadow operator-(const Shadow& x);
  friend Shadow operator+(const Shadow& x, const Shadow& y);
  friend Shadow operator-(const Shadow& x, const Shadow& y);
  friend Shadow operator*(const Shadow& x, const Shadow& y);
  friend Shadow operator/(const Shadow& x, const Shadow& y);
  Shadow& operator+=(const Shadow& x) { return *this = *this + x; }
  Shadow& operator-=(const Shadow& x) { return *this = *this - x; }
  Shadow& operator*=(const Shadow& x) { return *this = *this * x; }
  Shadow& operator/=(const Shadow& x) { return *this = *this / x; }

  friend bool operator==(const Shadow& x, const Shadow& y);
  friend std::partial_ordering operator<=>(const Shadow& x, const Shadow& y);

  friend bool isfinite(const Shadow& x);
  friend bool isinf(const Shadow& x);
  friend bool isnan(const Shadow& x);

  friend Shadow abs(const Shadow& x);
  /// x·y + z, rounded once.
  friend Shadow fma(const Shadow& x, const Shadow& y, const Shadow& z);
  friend Shadow sqrt(const Shadow& x);
  friend Shadow pow(const Shadow& x, int n);
  friend Shadow ldexp(const Shadow& x, int e);
  friend Shadow frexp(const Shadow& x, int* e);

  /// A finite number rounded to this many significant digits, to nearest, as "%g" writes it: "-1500", or
  /// "1.5e+07" where it is small or has more digits before the point. Final zeros are left out, or stay.
  friend std::string in_digits(const Shadow& x, int digits, bool has_final_zeros);

 private:
  struct Exactly {
    double value;
  };
  explicit Shadow(Exactly exactly);
  struct Unset {};
  explicit Shadow(Unset) {}
  friend struct Inside;

  // What MPFR knows a number by. It owns nothing outside, so that copies are copies of these.
  std::uint64_t digits_[5];
  std::int64_t exponent_;
  int kind_;
};

}  // namespace rayproof::viz

template <>
struct std::numeric_limits<rayproof::viz::Shadow> {
  static constexpr bool is_specialized = true;
  static rayproof::viz::Shadow infinity() { return std::numeric_limits<double>::infinity(); }
  static rayproof::viz::Shadow quiet_NaN() { return std::numeric_limits<double>::quiet_NaN(); }
};
