#pragma once
/// \file
/// Draws of single numbers and vectors. Each is exact in the type it is drawn in.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <rayproof/vec3.hpp>
#include <type_traits>

#include "case/case.hpp"
#include "generators/random.hpp"

namespace rayproof::draw {

/// The least and the greatest exponent of a normal number of type `T`: 2^lowest <= |x| < 2^(highest + 1).
template <class T>
inline constexpr int lowest_exponent = std::numeric_limits<T>::min_exponent - 1;
template <class T>
inline constexpr int highest_exponent = std::numeric_limits<T>::max_exponent - 1;

/// Any finite number, every bit pattern as likely as every other, -0 and subnormals included; but the
/// patterns of infinities and NaN stand for those of 1 <= |x| < 2, which therefore come twice as often.
template <class T>
[[nodiscard]] T bit_pattern(Random& random) {
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  constexpr auto exponent = std::bit_cast<Bits>(std::numeric_limits<T>::infinity());
  constexpr Bits top_of_exponent = exponent & ~(exponent >> 1U);
  auto bits = static_cast<Bits>(random.bits());
  if ((bits & exponent) == exponent) bits &= ~top_of_exponent;
  return std::bit_cast<T>(bits);
}

/// 2^k for a real k uniform in [low, high], of either sign.
template <class T>
[[nodiscard]] T magnitude(Random& random, double low, double high) {
  const auto x = static_cast<T>(std::exp2(random.uniform(low, high)));
  return random.one_in(2) ? x : -x;
}

/// Uniform in [-1, 1].
template <class T>
[[nodiscard]] T symmetric(Random& random) {
  return static_cast<T>(random.uniform(-1, 1));
}

/// A number that has broken somebody's code before: by name, not by chance.
template <class T>
[[nodiscard]] T special(Random& random) {
  using Limits = std::numeric_limits<T>;
  constexpr T normal = Limits::min(), subnormal = Limits::denorm_min(), ulp = Limits::epsilon();
  static constexpr T named[] = {
      0, 1, 2, 3, 0.5, 10, normal, subnormal, Limits::max(), ulp, 1 + ulp, normal - subnormal};
  const int choice = random.between(0, 15);
  const T sign = random.one_in(2) ? T(1) : T(-1);
  if (choice < 12) return sign * named[choice];
  if (choice < 14) return sign * std::ldexp(T(1), random.between(lowest_exponent<T>, highest_exponent<T>));
  return sign * static_cast<T>(random.between(0, 100));
}

/// `x` moved by `steps` steps along the floating-point numbers, no further than the greatest finite one.
template <class T>
[[nodiscard]] T nudged(T x, int steps) {
  const T goal = steps < 0 ? std::numeric_limits<T>::lowest() : std::numeric_limits<T>::max();
  for (int k = std::abs(steps); k > 0; --k) x = std::nextafter(x, goal);
  return x;
}

/// `bit_pattern` and `special` in the type of a precision.
[[nodiscard]] inline double bit_pattern(Random& random, Precision precision) {
  return in_precision(precision, [&]<class T>(T) { return double{bit_pattern<T>(random)}; });
}
[[nodiscard]] inline double special(Random& random, Precision precision) {
  return in_precision(precision, [&]<class T>(T) { return double{special<T>(random)}; });
}

/// `x` to the nearest number of a precision, or a few ulps beside it.
[[nodiscard]] inline double nudged(Precision precision, double x, int steps) {
  return in_precision(precision, [&]<class T>(T) { return double{nudged(static_cast<T>(x), steps)}; });
}

[[nodiscard]] inline int digits_of(Precision precision) {
  return in_precision(precision, []<class T>(T) { return std::numeric_limits<T>::digits; });
}

/// Any exponent of a normal number, at least `margin` from the least and the greatest.
[[nodiscard]] inline double any_exponent(Random& random, Precision precision, int margin) {
  return in_precision(precision, [&]<class T>(T) {
    return random.uniform(lowest_exponent<T> + margin, highest_exponent<T> - margin);
  });
}

/// A small length in a room of a few units: any power of two as likely as every other, down to the last
/// digits.
[[nodiscard]] inline double small_step(Random& random, Precision precision) {
  return std::exp2(random.uniform(2 - digits_of(precision), 0));
}

/// Three numbers from one draw.
[[nodiscard]] auto vector(auto&& draw) { return glm::vec<3, decltype(draw())>{draw(), draw(), draw()}; }

/// A direction, uniform on the unit sphere, of length 1 to double rounding.
[[nodiscard]] inline glm::dvec3 unit_vector(Random& random) {
  for (;;) {
    const glm::dvec3 v = vector([&] { return symmetric<double>(random); });
    const double squared = dot(v, v);
    if (squared > 0x1p-20 && squared <= 1) return (1 / std::sqrt(squared)) * v;
  }
}

/// A unit vector at right angles to the unit vector `n`.
[[nodiscard]] inline glm::dvec3 perpendicular(Random& random, const glm::dvec3& n) {
  for (;;) {
    const glm::dvec3 v = unit_vector(random);
    const glm::dvec3 across = v - dot(v, n) * n;
    const double squared = dot(across, across);
    if (squared > 0x1p-10) return (1 / std::sqrt(squared)) * across;
  }
}

}  // namespace rayproof::draw
