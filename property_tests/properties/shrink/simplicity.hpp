#pragma once
/// \file
/// Which of two cases a person reads more easily.

#include "case/case.hpp"

namespace rayproof {

/// How hard a case is to read: 0 for one whose numbers could all be left out. The order is total and has no
/// endless descents (it is a natural number), so that a shrinker that only ever goes down comes to an end.
///
/// Digits beyond the third of any number weigh most, then a transform, then the digits, exponents and signs
/// of all numbers, then how many different numbers there are.
[[nodiscard]] unsigned complexity(const Case& one);

/// How many significant decimal digits `x` needs to be read back at the precision; 0 for 0 and for
/// infinities.
[[nodiscard]] unsigned significant_digits(double x, Precision precision);

}  // namespace rayproof
