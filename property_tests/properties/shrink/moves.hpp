#pragma once
/// \file
/// The shrinker's moves: ways to a simpler case, and the simpler numbers that they try.

#include <functional>
#include <vector>

#include "case/case.hpp"

namespace rayproof {

/// Looks at a candidate, and takes it or not.
using Try = std::function<void(const Case&)>;

/// Makes every move, the boldest first: each offers candidates made from `best`, which changes with each that
/// is taken.
void make_moves(const Case& best, const Try& attempt);

/// Numbers near `x` that are easier to read, the easiest first: 0, 1, -1, whole numbers, powers of ten, few
/// decimal digits, short mantissas, smaller exponents. Each is rounded to the precision.
[[nodiscard]] std::vector<double> simpler_numbers(double x, Precision precision);

/// `x` to `digits` significant decimal digits, moved by `steps` units of the last of them.
[[nodiscard]] double to_digits(double x, int digits, int steps, Precision precision);

}  // namespace rayproof
