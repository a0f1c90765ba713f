#pragma once
/// \file
/// The shrinker's moves: ways to a simpler case, and the simpler numbers that they try.

#include <functional>
#include <span>
#include <vector>

#include "case/case.hpp"

namespace rayproof {

/// Looks at a candidate, and takes it or not.
using Try = std::function<void(const Case&)>;

/// Offers candidates made from `best`, which may change with each that is taken; how many numbers it has
/// changes in no move but those that leave something out.
using Move = void (*)(const Case& best, const Try& attempt);

/// Every move, the boldest first.
[[nodiscard]] std::span<const Move> moves();

/// Numbers near `x` that are easier to read, the easiest first: 0, 1, -1, whole numbers, powers of ten, few
/// decimal digits, short mantissas, smaller exponents. Each is rounded to the precision.
[[nodiscard]] std::vector<double> simpler_numbers(double x, Precision precision);

/// `x` to `digits` significant decimal digits, moved by `steps` units of the last of them.
[[nodiscard]] double to_digits(double x, int digits, int steps, Precision precision);

}  // namespace rayproof
