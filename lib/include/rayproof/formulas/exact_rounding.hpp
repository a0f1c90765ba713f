#pragma once
/// \file
/// The last step of the compensated methods: an exact number, known by an estimate and by exact comparisons,
/// becomes a plain number on its own side of the interval's ends.

#include <bit>
#include <cmath>
#include <cstdint>
#include <rayproof/arithmetics/expansion.hpp>
#include <rayproof/formulas/finite.hpp>
#include <rayproof/method/narration.hpp>
#include <rayproof/roots.hpp>
#include <type_traits>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

namespace steps {
inline constexpr Step round_quotients{
    "Round each quotient once",
    "Numerator and denominator are exact, so each result has only the error of its own rounding."};
}  // namespace steps

/// Halfway between the greatest float and the power of two that would follow: what is not below rounds to
/// infinity. No such double lies within the domain of the bounds in double.
template <class T>
inline constexpr double infinite_from = sizeof(T) < sizeof(double) ? 0x1.ffffffp127
                                                                   : std::numeric_limits<double>::infinity();

/// Whether rounding a double to T can't carry it across an end: it is clear, by 2^-22 of its size, of both
/// ends of the ray's interval and of the ends of T's normal numbers.
template <std::floating_point T>
[[nodiscard]] inline bool is_clear_of_ends(const Ray<double>& ray, double t) {
  const double size = abs(t);
  const double nearest = min(min(abs(t - ray.t_min), abs(t - ray.t_max)), abs(size - infinite_from<T>));
  return size >= double{std::numeric_limits<T>::min()} && nearest > 0x1p-22 * size;
}

/// Halfway between two neighbouring numbers, exactly: a float's midpoints are doubles, a double's are sums of
/// two.
[[nodiscard]] inline Expansion<double, 1> midpoint(float x, float next) {
  const bool is_end = !(abs(x) < infinity<float> && abs(next) < infinity<float>);
  return exact(is_end ? copysign(infinite_from<float>, double{x}) : (double{x} + double{next}) / 2);
}
[[nodiscard]] inline Expansion<double, 2> midpoint(double x, double next) {
  return exact((next - x) / 2) + exact(x);
}

/// Whether the last digit of the significand is 1.
template <std::floating_point T>
[[nodiscard]] inline bool is_odd(T x) {
  using Bits = std::conditional_t<sizeof(T) == sizeof(std::uint32_t), std::uint32_t, std::uint64_t>;
  return std::bit_cast<Bits>(x) % 2 == 1;
}

/// An exact number in T, rounded once, to nearest with ties to even; infinite where it overflows, and never
/// -0. The estimate is within 2^-48 of the number's size, or for a T of double within 2^-50; `compare(x)` is
/// the exact sign of (number - x) for an expansion x.
///
/// A float's midpoints are looked at only where the estimate is within 2^-46 of one.
template <std::floating_point T, class Compare>
[[nodiscard]] T correctly_rounded(double estimated, Compare&& compare) {
  auto t = static_cast<T>(estimated);
  if (t != t) return t;
  const auto is_beyond_midpoint = [&](T end) {
    const T next = std::nextafter(t, end);
    if (next == t) return false;
    const auto middle = midpoint(t, next);
    const double distance = estimate(middle) - estimated;
    if (!(abs(distance) < infinity<double>)) return false;
    if (sizeof(T) < sizeof(double) && abs(distance) > 0x1p-46 * abs(estimated)) return false;
    const int side = compare(middle) * (end > 0 ? 1 : -1);
    return side > 0 || (side == 0 && is_odd(t));
  };
  constexpr int most_steps = 8;  // 2^-50 of a double; outside of its domain an estimate may be anything
  for (const T end : {infinity<T>, -infinity<T>}) {
    for (int i = 0; i < most_steps && is_beyond_midpoint(end); ++i) t = std::nextafter(t, end);
  }
  return t + T(0);
}

/// The same on the number's own side of each end of the ray's interval: rounding carries it onto an end at
/// most, and never over.
template <class T, class Compare>
[[nodiscard]] T rounded(const Ray<T>& ray, double estimated, Compare&& compare) {
  const T t = correctly_rounded<T>(estimated, compare);
  if (!(abs(t) < infinity<T>)) return t;
  const int side = t == ray.t_min || t == ray.t_max ? compare(exact(static_cast<double>(t))) : 0;
  if (t == ray.t_min && side < 0) return std::nextafter(t, -infinity<T>);
  return t == ray.t_max && side > 0 ? std::nextafter(t, infinity<T>) : t;
}

/// numerator / denominator, both exact: expansions of a fixed capacity or growing ones. The denominator is
/// not 0 where the ratio is of use.
template <class Numerator, class Denominator>
struct ExactRatio {
  Numerator numerator;
  Denominator denominator;
  /// Within 2^-50 of its size: spares most comparisons their exact products.
  double approximate = estimate(numerator) / estimate(denominator);

  /// The exact sign of (ratio - x).
  template <std::size_t K>
  [[nodiscard]] int compare(const Expansion<double, K>& x) const {
    return sign(numerator - denominator * x) * sign(denominator);
  }
  /// The exact sign of (ratio - other).
  [[nodiscard]] int compare(const ExactRatio& other) const {
    const double difference = approximate - other.approximate;
    const double doubt = 0x1p-48 * (abs(approximate) + abs(other.approximate));
    if (abs(difference) > doubt) return difference > 0 ? 1 : -1;
    return sign(numerator * other.denominator - other.numerator * denominator) * sign(denominator) *
           sign(other.denominator);
  }
};
template <class Numerator, class Denominator>
ExactRatio(Numerator, Denominator) -> ExactRatio<Numerator, Denominator>;

/// The ratio in T, rounded once, on its own side of the ends of the ray's interval: in_interval(ray, t)
/// is what it is for the exact ratio.
template <std::floating_point T, class Numerator, class Denominator>
[[nodiscard]] T rounded(const Ray<T>& ray, const ExactRatio<Numerator, Denominator>& ratio) {
  return rounded(ray, ratio.approximate, [&](const auto& x) { return ratio.compare(x); });
}

/// The same where no interval is to be minded.
template <std::floating_point T, class Numerator, class Denominator>
[[nodiscard]] T rounded_alone(const ExactRatio<Numerator, Denominator>& ratio) {
  const Ray<T> whole_line{{}, {}, -infinity<T>, infinity<T>};
  return rounded(whole_line, ratio);
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
