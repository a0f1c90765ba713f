#pragma once
/// \file
/// Answers seen as lists of numbers: compared bit for bit, stretched, mirrored.

#include <vector>

#include "case/answer.hpp"

namespace rayproof {

/// The t of the hits, or the roots, ascending; none for a position.
[[nodiscard]] std::vector<double> numbers_in(const Answer& answer);

/// Whether the answer has a hit, a root, or a place that is not outside.
[[nodiscard]] bool finds_something(const Answer& answer);

/// Whether it says where its hits are, and not only that there are some.
[[nodiscard]] bool gives_numbers(const Answer& answer);

/// Whether two answers are the same: the kind, the count, and every number (0 equals -0, NaN equals NaN).
[[nodiscard]] bool same(const Answer& a, const Answer& b);

/// The answer with every t or root multiplied by `factor`, in ascending order again where it is negative. A
/// hit's point and normal are dropped.
[[nodiscard]] Answer stretched(const Answer& answer, double factor);

}  // namespace rayproof
