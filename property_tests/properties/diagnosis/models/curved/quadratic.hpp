#pragma once
/// \file
/// Models of faults with the quadratic equation.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// The equation with a = 0 is not handled.
[[nodiscard]] std::optional<bool> wrong_where_linear(const Case& one, const Answer& got, const Answer& exact);
/// The equation with a = b = 0 is not handled.
[[nodiscard]] std::optional<bool> wrong_where_constant(const Case& one, const Answer& got,
                                                       const Answer& exact);
/// The equation with a = b = c = 0 is not handled.
[[nodiscard]] std::optional<bool> wrong_where_all_is_zero(const Case& one, const Answer& got,
                                                          const Answer& exact);
/// The equation with c = 0 is not handled.
[[nodiscard]] std::optional<bool> wrong_where_c_is_zero(const Case& one, const Answer& got,
                                                        const Answer& exact);
/// The same of b = 0.
[[nodiscard]] std::optional<bool> wrong_where_b_is_zero(const Case& one, const Answer& got,
                                                        const Answer& exact);
/// The same of b = c = 0.
[[nodiscard]] std::optional<bool> wrong_where_square(const Case& one, const Answer& got, const Answer& exact);
/// A double root is no root.
[[nodiscard]] Answers double_root_missed(const Case& one, const Answer& exact);
/// The root of |D| is taken: roots where there are none.
[[nodiscard]] Answers discriminant_without_sign(const Case& one, const Answer& exact);
/// @{ Where a = 0 the root is c/b, or -b/c.
[[nodiscard]] Answers linear_root_negated(const Case& one, const Answer& exact);
[[nodiscard]] Answers linear_root_inverted(const Case& one, const Answer& exact);
/// @}
/// @{ Readings: b with the other sign (0), c with the other sign (1), a and c exchanged (2), b and c (3), a
/// and b (4).
[[nodiscard]] std::vector<Case> with_coefficients(const Case& one,
                                                  void (*change)(Quadratic<double>& equation));
template <int mistake>
[[nodiscard]] std::vector<Case> coefficients_with(const Case& one) {
  return with_coefficients(one, [](Quadratic<double>& equation) {
    if (mistake == 0) equation.b = -equation.b;
    if (mistake == 1) equation.c = -equation.c;
    if (mistake == 2) std::swap(equation.a, equation.c);
    if (mistake == 3) std::swap(equation.b, equation.c);
    if (mistake == 4) std::swap(equation.a, equation.b);
  });
}
/// @}
/// The reading of an equation whose a is smaller than 10^power: a = 0.
[[nodiscard]] std::vector<Case> with_small_a_as_zero(const Case& one, double least);
template <int power>
[[nodiscard]] std::vector<Case> small_a_as_zero(const Case& one) {
  return with_small_a_as_zero(one, std::pow(10.0, power));
}
/// The same where a is smaller than 10^power of b.
template <int power>
[[nodiscard]] std::vector<Case> small_a_beside_b(const Case& one) {
  const auto* equation = std::get_if<Quadratic<double>>(&one.question);
  return equation == nullptr ? std::vector<Case>{}
                             : with_small_a_as_zero(one, std::pow(10.0, power) * std::abs(equation->b));
}
/// A double root is the right one times a factor.
[[nodiscard]] Answers double_root_times(const Answer& exact, double factor);
[[nodiscard]] inline Answers double_root_halved(const Case& /*one*/, const Answer& exact) {
  return double_root_times(exact, 0.5);
}
[[nodiscard]] inline Answers double_root_doubled(const Case& /*one*/, const Answer& exact) {
  return double_root_times(exact, 2);
}
[[nodiscard]] inline Answers double_root_negated(const Case& /*one*/, const Answer& exact) {
  return double_root_times(exact, -1);
}
/// The same of what is not divided by a, or by 2a, or is multiplied by a.
[[nodiscard]] Answers double_root_undivided(const Case& one, const Answer& exact);
/// The equation with a double root is not handled.
[[nodiscard]] std::optional<bool> wrong_where_double(const Case& one, const Answer& got, const Answer& exact);

/// Only the roots that are not negative are given; the real part of complex roots is given.
[[nodiscard]] Answers positive_roots_alone(const Case& one, const Answer& exact);
[[nodiscard]] Answers real_part(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
