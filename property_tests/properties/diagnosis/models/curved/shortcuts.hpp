#pragma once
/// \file
/// Models of faults in what a solver of quadratic equations does beside its formula: special cases that are
/// answered by another one, and roots that are filtered or derived.

#include <cmath>

#include "properties/diagnosis/models/curved/root_formula.hpp"

namespace rayproof::diagnosis {

/// An equation with b² above a multiple of |ac|, or of 4|ac|, is taken for a linear one: the farther root is
/// dropped.
[[nodiscard]] Answers large_b_as_linear(const Case& one, const Answer& exact, double multiple);
template <int power>
[[nodiscard]] Answers large_b_as_linear(const Case& one, const Answer& exact) {
  return large_b_as_linear(one, exact, std::pow(10.0, power));
}

/// Of an equation that has this root, 0, 1 or -1, that is given first, or last, whatever the other one is.
/// An answer for each.
[[nodiscard]] Answers fixed_place_of(const Case& one, double root);
template <int root>
[[nodiscard]] Answers fixed_place_of(const Case& one, const Answer& /*exact*/) {
  return fixed_place_of(one, root);
}
/// Whether an equation with a + b + c = 0 is answered wrongly; nothing of another one.
[[nodiscard]] std::optional<bool> wrong_where_sum_is_zero(const Case& one, const Answer& got,
                                                          const Answer& exact);

/// @{ A root 0 is left out: that of a linear equation alone, or every one.
[[nodiscard]] Answers linear_zero_missed(const Case& one, const Answer& exact);
[[nodiscard]] Answers zero_missed(const Case& one, const Answer& exact);
/// @}
/// Whether the equation is not linear.
[[nodiscard]] bool has_square(const Case& one, const Answer& exact);

/// @{ One root is right, and the other is -b less that: the sum of the roots is -b/a.
[[nodiscard]] FoundRoots second_by_sum(const ReducedEquation& e);
[[nodiscard]] FoundRoots first_by_sum(const ReducedEquation& e);
/// @}

/// Whether the answer to a case of float64 is that of a formula whose D is rounded to a float: b² - 4ac or a
/// quarter of it, in the textbook's formula or in the one that does not cancel. Nothing where that cannot be
/// distinguished from the exact answer.
[[nodiscard]] std::optional<bool> has_discriminant_in_float(const Case& one, const Answer& got,
                                                            const Answer& exact);

}  // namespace rayproof::diagnosis
