#pragma once
/// \file
/// Models of coefficients of an equation that are 0, or are taken for another number.

#include <cmath>

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// @{ A sphere is missed where b is 0, or where b or c is; an answer for each. And whether b is 0.
[[nodiscard]] Answers missed_with_zero_coefficient(const Case& one, const Answer& exact);
[[nodiscard]] bool has_no_linear_term(const Case& one, const Answer& exact);
/// @}
/// A sphere's a is taken for 1 where the direction is shorter than 1, or longer. An answer for each.
[[nodiscard]] Answers a_as_one_by_length(const Case& one, const Answer& exact);
/// The half of b is rounded down to a whole number, or cut off. An answer for each.
[[nodiscard]] Answers half_b_made_whole(const Case& one, const Answer& exact);
/// Where c = 0 the root beside 0 is -b, b/a or -b/(2a). An answer for each.
[[nodiscard]] Answers root_beside_zero(const Case& one, const Answer& exact);

/// @{ The readings of an equation whose c, or b, is smaller than a number, or than a share of the other: 0.
[[nodiscard]] std::vector<Case> with_small_as_zero(const Case& one, double Quadratic<double>::*small,
                                                   double least);
template <double Quadratic<double>::*small, int power>
[[nodiscard]] std::vector<Case> small_as_zero(const Case& one) {
  return with_small_as_zero(one, small, std::pow(10.0, power));
}
template <double Quadratic<double>::*small, double Quadratic<double>::*other, int power>
[[nodiscard]] std::vector<Case> small_beside(const Case& one) {
  const auto* equation = std::get_if<Quadratic<double>>(&one.question);
  return equation == nullptr
             ? std::vector<Case>{}
             : with_small_as_zero(one, small, std::pow(10.0, power) * std::abs(equation->*other));
}
/// @}

}  // namespace rayproof::diagnosis
