#pragma once
/// \file
/// How large a mistake is that has one size in all cases: a factor, or a length that is added.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// Which of two numbers bear the mistake.
enum class Bears { both, first, second };

/// By what factor, less 1, the numbers of the answer are off: all of them, or the first or second root, or
/// hit of the line, alone.
[[nodiscard]] std::optional<double> factor_of(const Case& one, const Answer& got, const Answer& exact,
                                              Bears which);
template <Bears which>
[[nodiscard]] std::optional<double> factor_of(const Case& one, const Answer& got, const Answer& exact) {
  return factor_of(one, got, exact, which);
}
/// What is added to every number; and that as a length along the ray.
[[nodiscard]] std::optional<double> added_to_numbers(const Case& one, const Answer& got, const Answer& exact);
[[nodiscard]] std::optional<double> added_in_lengths(const Case& one, const Answer& got, const Answer& exact);

/// @{ Of a sphere: by what factor, less 1, the radius is off that the hits lie on; and by what length.
[[nodiscard]] std::optional<double> factor_of_radius(const Case& one, const Answer& got, const Answer& exact);
[[nodiscard]] std::optional<double> added_to_radius(const Case& one, const Answer& got, const Answer& exact);
[[nodiscard]] Answers with_radius_times(const Case& one, const Answer& exact, double more);
[[nodiscard]] Answers with_radius_plus(const Case& one, const Answer& exact, double more);
/// @}

}  // namespace rayproof::diagnosis
