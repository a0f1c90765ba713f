#pragma once
/// \file
/// The arithmetic that stands in for real numbers in walkthroughs and pictures; and numbers as a person reads
/// them.

#include <compare>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

#include "case/case.hpp"

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

namespace rayproof::viz {

/// The shortest decimal that reads back as the same number of the precision; "∞", "−∞", "NaN".
[[nodiscard]] std::string shown(double value, Precision precision);
[[nodiscard]] std::string shown(const glm::dvec3& v, Precision precision);
/// A number in real arithmetic, beside `value`, which is it rounded to a format of `bits` bits: float or
/// double. Where the two are equal, the shortest decimal that reads back as the same double. Else 12 digits
/// beside a float and 17 beside a double, or as many more as set them apart; final zeros stay, since 0.25
/// beside 0.25 would look equal.
[[nodiscard]] std::string exact_beside(const Shadow& exact, double value, int bits);
/// Up to `digits` significant digits.
[[nodiscard]] std::string rough(double value, int digits = 3);
[[nodiscard]] std::string rough(const Shadow& value, int digits = 3);
/// What a drawing at `times` the size of the thing says of itself: "Magnified ×20", "Reduced to 1/20".
[[nodiscard]] std::string scale_in_words(const Shadow& times);
[[nodiscard]] std::string subscript(std::size_t index);
/// How many numbers of the precision lie from `a` to `b`, 0 and -0 being one: counted in integers, and the
/// count rounded once to double (exact up to 2^53). Infinite where one is NaN, or where one of two different
/// numbers is infinite.
[[nodiscard]] double count_ulps(double a, double b, Precision precision);
/// "1 ulp", "639 ulps", "3.9e7 ulps".
[[nodiscard]] std::string in_ulps(double ulps);
/// Of an answer this many ulps from the correctly rounded one: "the exact one, correctly rounded", "off by
/// 639 ulps", "infinitely far off".
[[nodiscard]] std::string accuracy_in_words(double ulps);
/// The distance of a number from the exact one, `a`: "equal", "639 ulps", "infinitely far"; the difference
/// itself, "0.037", beyond a hundredth of `a`.
[[nodiscard]] std::string apart_in_words(double a, double b, Precision precision);

}  // namespace rayproof::viz
