#pragma once
/// \file
/// The last step of the compensated methods: an exact number, known by an estimate and by exact comparisons,
/// becomes a plain number on its own side of the interval's ends.

#include <rayproof/arithmetics/expansion.hpp>
#include <rayproof/formulas/finite.hpp>
#include <rayproof/method/narration.hpp>
#include <rayproof/roots.hpp>

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

/// t in T; beside the greatest float, the exact number says whether it is infinite. `compare(x)` is the exact
/// sign of (number - x).
template <class T, class Compare>
[[nodiscard]] T narrowed(double t, Compare&& compare) {
  if (!(abs(abs(t) - infinite_from<T>) <= 0x1p-40 * abs(t))) return static_cast<T>(t);
  const int beyond = compare(copysign(infinite_from<T>, t)) * (t > 0 ? 1 : -1);
  return static_cast<T>(copysign(beyond < 0 ? double{std::numeric_limits<T>::max()} : infinity<double>, t));
}

/// An exact number in T, on its own side of each end of the ray's interval. The estimate is within 0.6 ulp,
/// so that rounding carries it onto an end at most, and never over. `compare(x)` is the exact sign of (number
/// - x).
template <class T, class Compare>
[[nodiscard]] T rounded(const Ray<T>& ray, double estimated, Compare&& compare) {
  T t = narrowed<T>(estimated, compare);
  const auto is_near = [&](T end) { return abs(end) < infinity<T> && std::nextafter(t, end) == end; };
  if (is_near(ray.t_min) && compare(static_cast<double>(ray.t_min)) < 0) {
    t = std::nextafter(ray.t_min, -infinity<T>);
  }
  if (is_near(ray.t_max) && compare(static_cast<double>(ray.t_max)) > 0) {
    t = std::nextafter(ray.t_max, infinity<T>);
  }
  return t;
}

/// numerator / denominator, both exact expansions; the denominator is not 0 where the ratio is of use.
template <std::size_t N, std::size_t M>
struct ExactRatio {
  Expansion<double, N> numerator;
  Expansion<double, M> denominator;
  /// Within 2^-50 of its size: spares most comparisons their exact products.
  double approximate = estimate(numerator) / estimate(denominator);

  /// The exact sign of (ratio - x) for a finite x.
  [[nodiscard]] int compare(double x) const {
    return sign(numerator - denominator * exact(x)) * sign(denominator);
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
template <std::size_t N, std::size_t M>
ExactRatio(Expansion<double, N>, Expansion<double, M>) -> ExactRatio<N, M>;

/// The ratio in T, within 0.501 ulp, on its own side of the ends of the ray's interval: in_interval(ray, t)
/// is what it is for the exact ratio.
template <std::floating_point T, std::size_t N, std::size_t M>
[[nodiscard]] T rounded(const Ray<T>& ray, const ExactRatio<N, M>& ratio) {
  double t = ratio.approximate;
  if (sizeof(T) == sizeof(double) && abs(t) < infinity<double>) {
    t += estimate(ratio.numerator - ratio.denominator * exact(t)) / estimate(ratio.denominator);
  }
  return rounded(ray, t, [&](double x) { return ratio.compare(x); });
}

/// The same where no interval is to be minded.
template <std::floating_point T, std::size_t N, std::size_t M>
[[nodiscard]] T rounded_alone(const ExactRatio<N, M>& ratio) {
  const Ray<T> whole_line{{}, {}, -infinity<T>, infinity<T>};
  return rounded(whole_line, ratio);
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
