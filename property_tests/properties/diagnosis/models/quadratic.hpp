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
/// D = b² + 4ac.
[[nodiscard]] Answers discriminant_with_plus(const Case& one, const Answer& exact);
/// D = b² - ac.
[[nodiscard]] Answers discriminant_without_four(const Case& one, const Answer& exact);
/// Where a = 0 the root is c/b.
[[nodiscard]] Answers linear_root_negated(const Case& one, const Answer& exact);

/// Only the roots that are not negative are given; the real part of complex roots is given.
[[nodiscard]] Answers positive_roots_alone(const Case& one, const Answer& exact);
[[nodiscard]] Answers real_part(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
