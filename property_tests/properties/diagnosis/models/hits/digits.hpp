#pragma once
/// \file
/// Marks of answers that have lost digits.

#include <cmath>

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// Every number is one of float32, in a case of float64.
[[nodiscard]] std::optional<bool> is_of_float(const Case& one, const Answer& got, const Answer& exact);
/// The answer to a case of float64 is off by what a float rounds, and by no more.
[[nodiscard]] std::optional<bool> is_right_to_float(const Case& one, const Answer& got, const Answer& exact);
/// The same of a triangle's barycentric coordinates, in units of 1.
[[nodiscard]] std::optional<bool> coordinates_right_to_float(const Case& one, const Answer& got,
                                                             const Answer& exact);
/// The same of the point of a hit.
[[nodiscard]] std::optional<bool> point_right_to_float(const Case& one, const Answer& got,
                                                       const Answer& exact);
/// Every number is one of float16.
[[nodiscard]] std::optional<bool> is_of_half(const Case& one, const Answer& got, const Answer& exact);
/// Every number is right to two to five decimal digits, and no better.
[[nodiscard]] std::optional<bool> is_approximate(const Case& one, const Answer& got, const Answer& exact);
/// The hits of a solid are as far off as a root would be that is right to two to five digits, in shares of
/// half the chord between them.
[[nodiscard]] std::optional<bool> has_approximate_root(const Case& one, const Answer& got,
                                                       const Answer& exact);
/// The hits are off by a small share of the scene, or a wrong verdict by no more: what an approximation does
/// that all goes through. Hits that are right to their last digits speak against it.
[[nodiscard]] std::optional<bool> is_off_by_a_share(const Case& one, const Answer& got, const Answer& exact);
/// Every hit is right to about this length of the scene, whatever the scene's size, and no better.
[[nodiscard]] std::optional<bool> is_right_to_length(const Case& one, const Answer& got, const Answer& exact,
                                                     double length);
template <int power>
[[nodiscard]] std::optional<bool> is_right_to_length(const Case& one, const Answer& got,
                                                     const Answer& exact) {
  return is_right_to_length(one, got, exact, std::pow(10.0, power));
}
/// Every number has six decimal digits at most.
[[nodiscard]] std::optional<bool> has_six_digits(const Case& one, const Answer& got, const Answer& exact);

/// @{ No number of the answer has more than six decimals, or any at all.
[[nodiscard]] std::optional<bool> has_six_decimals(const Case& one, const Answer& got, const Answer& exact);
[[nodiscard]] std::optional<bool> has_whole_numbers(const Case& one, const Answer& got, const Answer& exact);
/// @}

}  // namespace rayproof::diagnosis
