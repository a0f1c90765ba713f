#pragma once
/// \file
/// Models of faults that show in the values of t, or of roots: infinite, no number, or 0.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// A number of the answer is infinite, in ordinary numbers, and none should be.
[[nodiscard]] std::optional<bool> is_infinite(const Case& one, const Answer& got, const Answer& exact);
/// The line's hits are all given at t = 0, if the interval admits that.
[[nodiscard]] Answers all_at_zero(const Case& one, const Answer& exact);
/// Every t of the answer is 0, and none should be.
[[nodiscard]] std::optional<bool> is_all_zero(const Case& one, const Answer& got, const Answer& exact);
/// A number that is no number, or infinite.
[[nodiscard]] std::optional<bool> is_nan(const Case& one, const Answer& got, const Answer& exact);

}  // namespace rayproof::diagnosis
