#pragma once
/// \file
/// Models of faults in the unit of t, or in a denominator: every number of the answer is the right one times
/// a quantity of the case.

#include <algorithm>
#include <cmath>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// A quantity of the case; nothing where the case has none.
using Quantity = std::optional<double> (*)(const Case&);

/// The hits or roots times the factor: those of the exact answer, and those of the line that the interval
/// admits when so multiplied.
[[nodiscard]] Answers times(const Case& one, const Answer& exact, double factor);

/// The hits of the line times the factor, as far as the interval admits them then.
[[nodiscard]] Answers line_times(const Case& one, double factor);

/// Every t of the line without its sign, as far as the interval admits it then; every root without its sign.
[[nodiscard]] Answers absolute(const Case& one, const Answer& exact);
/// Every t of the line is 1 / t, as far as the interval admits it then.
[[nodiscard]] Answers reciprocal(const Case& one, const Answer& exact);
/// Every number is made a whole one, or otherwise rounded.
[[nodiscard]] Answers made_whole(const Case& one, const Answer& exact, double (*whole)(double));
/// By rounding down, as a division of integers does in Python.
[[nodiscard]] inline Answers rounded_down(const Case& one, const Answer& exact) {
  return made_whole(one, exact, [](double x) { return std::floor(x); });
}
/// To the nearest whole number.
[[nodiscard]] inline Answers rounded_to_whole(const Case& one, const Answer& exact) {
  return made_whole(one, exact, [](double x) { return std::round(x); });
}
/// By cutting off what follows the point, as an integer does in C++.
[[nodiscard]] inline Answers cut_off(const Case& one, const Answer& exact) {
  return made_whole(one, exact, [](double x) { return std::trunc(x); });
}

/// To a number of decimals.
template <int decimals>
[[nodiscard]] Answers rounded_to_decimals(const Case& one, const Answer& exact) {
  return made_whole(one, exact, [](double x) { return on_grid(x, std::pow(10.0, decimals)); });
}

/// Whether a number that is not made 0 so loses more than a thousandth of it.
template <int decimals>
[[nodiscard]] bool loses_decimals(const Case& /*one*/, const Answer& exact) {
  return std::ranges::any_of(numbers_in(exact), [](double x) {
    const double rounded = on_grid(x, std::pow(10.0, decimals));
    return rounded != 0 && std::abs(rounded - x) > 1e-3 * std::abs(x);
  });
}

/// Every t or root is the right one times (or, with power -1, divided by) the quantity.
template <Quantity quantity, int power = 1>
[[nodiscard]] Answers scaled_by(const Case& one, const Answer& exact) {
  const std::optional<double> factor = quantity(one);
  if (!factor || *factor == 0 || !std::isfinite(*factor)) return {};
  return times(one, exact, power > 0 ? *factor : 1 / *factor);
}

/// Every t of the line is the right one times the quantity, and is compared with the interval after that.
template <Quantity quantity, int power = 1>
[[nodiscard]] Answers line_scaled_by(const Case& one, const Answer& /*exact*/) {
  const std::optional<double> factor = quantity(one);
  if (!factor || *factor == 0) return {};
  return line_times(one, power > 0 ? *factor : 1 / *factor);
}

/// @{ Of any question.
[[nodiscard]] std::optional<double> minus_one(const Case& one);
[[nodiscard]] std::optional<double> two(const Case& one);
/// @}
/// @{ Of a ray: the length of the direction, its square, its length in the object's space.
[[nodiscard]] std::optional<double> length_of_direction(const Case& one);
[[nodiscard]] std::optional<double> square_of_direction(const Case& one);
[[nodiscard]] std::optional<double> length_in_object(const Case& one);
/// How much longer it is in the object's space.
[[nodiscard]] std::optional<double> stretch_of_direction(const Case& one);
/// @}
/// @{ Of a sphere and a ray, in the object's space: the constant |origin - center|² - r² of its equation, its
/// radius.
[[nodiscard]] std::optional<double> constant_of_sphere(const Case& one);
[[nodiscard]] std::optional<double> radius_of_sphere(const Case& one);
/// @}
/// @{ Of a quadratic: its coefficients.
[[nodiscard]] std::optional<double> coefficient_a(const Case& one);
[[nodiscard]] std::optional<double> square_of_a(const Case& one);
[[nodiscard]] std::optional<double> coefficient_c(const Case& one);
/// @}
/// Of a plane or a flat figure: its normal times the direction.
[[nodiscard]] std::optional<double> slope(const Case& one);
[[nodiscard]] std::optional<double> minus_slope(const Case& one);
/// @{ 1 where the surface is seen from behind, -1 from the front; and the other way round.
[[nodiscard]] std::optional<double> sign_of_slope(const Case& one);
[[nodiscard]] std::optional<double> minus_sign_of_slope(const Case& one);
/// @}
/// |n·d| with n of length 1: t times this is the distance from the plane.
[[nodiscard]] std::optional<double> distance_per_t(const Case& one);
/// Of a plane with a normal, or a figure with one: the normal's length.
[[nodiscard]] std::optional<double> length_of_normal(const Case& one);

}  // namespace rayproof::diagnosis
