#pragma once
/// \file
/// Models of faults in the discriminant, and in the formula for two roots that does not cancel.

#include "properties/diagnosis/models/curved/root_formula.hpp"

namespace rayproof::diagnosis {

/// A term of D = b² - 4ac is another one: a power, a factor, a coefficient or the sign; in the textbook's
/// formula and in the one that does not cancel.
[[nodiscard]] Answers wrong_discriminant(const Case& one, const Answer& exact);

/// @{ In the formula that does not cancel, x = q / a and y = c / q, one root has the wrong sign; or y = c /
/// a, or one of the two fractions upside down.
[[nodiscard]] FoundRoots first_root_negated(const ReducedEquation& e);
[[nodiscard]] FoundRoots second_root_negated(const ReducedEquation& e);
[[nodiscard]] FoundRoots both_divided_by_a(const ReducedEquation& e);
[[nodiscard]] FoundRoots first_upside_down(const ReducedEquation& e);
[[nodiscard]] FoundRoots second_upside_down(const ReducedEquation& e);
/// @}
/// @{ One of the two has a factor 2 too many, or too few.
[[nodiscard]] FoundRoots first_doubled(const ReducedEquation& e);
[[nodiscard]] FoundRoots second_doubled(const ReducedEquation& e);
[[nodiscard]] FoundRoots first_halved(const ReducedEquation& e);
[[nodiscard]] FoundRoots second_halved(const ReducedEquation& e);
/// @}
/// @{ In (-h ± √D) / a, h = b/2, one root alone is not divided.
[[nodiscard]] FoundRoots first_undivided(const ReducedEquation& e);
[[nodiscard]] FoundRoots second_undivided(const ReducedEquation& e);
/// @}

/// In the formula that does not cancel the sign of b = 0 is 0, and so is q: its roots are 0 and what c / 0 is
/// taken for.
[[nodiscard]] Answers sign_of_zero(const Case& one, const Answer& exact);

/// Where b = 0 the roots are ±√(c/a), and must be ±√(-c/a).
[[nodiscard]] Answers pure_square_negated(const Case& one, const Answer& exact);

/// Whether the product of two roots is c/a and their sum is not -b/a, and not by a loss of digits: so it is
/// where in x = q / a and y = c / q the number q is wrong.
[[nodiscard]] std::optional<bool> number_q_wrong(const Case& one, const Answer& got, const Answer& exact);

}  // namespace rayproof::diagnosis
