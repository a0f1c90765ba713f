#pragma once
/// \file
/// Models of an absolute epsilon on the discriminant: of a quadratic equation, a sphere, the side of a
/// cylinder.

#include <cmath>

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// A discriminant below the limit, in one of the forms that textbooks have, is taken for negative, or for 0.
[[nodiscard]] Answers small_discriminant(const Case& one, const Answer& exact, double limit);
template <int power>
[[nodiscard]] Answers small_discriminant(const Case& one, const Answer& exact) {
  return small_discriminant(one, exact, std::pow(10.0, power));
}

/// One below a share of b² is taken for 0; a negative one may be, too.
[[nodiscard]] Answers nearly_double_root(const Case& one, const Answer& exact, double share);
template <int power>
[[nodiscard]] Answers nearly_double_root(const Case& one, const Answer& exact) {
  return nearly_double_root(one, exact, std::pow(10.0, power));
}

/// One that is negative by less than the limit is taken for 0.
[[nodiscard]] Answers negative_discriminant(const Case& one, const Answer& exact, double limit);
/// Every negative one is.
[[nodiscard]] inline Answers clamped_discriminant(const Case& one, const Answer& exact) {
  return negative_discriminant(one, exact, HUGE_VAL);
}
template <int power>
[[nodiscard]] Answers negative_discriminant(const Case& one, const Answer& exact) {
  return negative_discriminant(one, exact, std::pow(10.0, power));
}
/// A crossing whose discriminant is below the limit is called tangent.
[[nodiscard]] Answers called_tangent_below(const Case& one, const Answer& exact, double limit);
template <int power>
[[nodiscard]] Answers called_tangent_below(const Case& one, const Answer& exact) {
  return called_tangent_below(one, exact, std::pow(10.0, power));
}

}  // namespace rayproof::diagnosis
