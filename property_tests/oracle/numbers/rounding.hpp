#pragma once
/// \file
/// Correct rounding of an exactly comparable number.

#include "oracle/numbers/quotient.hpp"
#include "oracle/numbers/root.hpp"
#include "oracle/numbers/ulp.hpp"

namespace rayproof::oracle {

/// The number rounded to nearest, ties to even, in the case's precision; infinite where it overflows.
[[nodiscard]] double round_correctly(const ExactRoot& root, Precision precision);
[[nodiscard]] double round_correctly(const Quotient& quotient, Precision precision);

}  // namespace rayproof::oracle
