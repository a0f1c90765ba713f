#pragma once
/// \file
/// Correct rounding of an exactly comparable number.

#include "oracle/numbers/quotient.hpp"
#include "oracle/numbers/root.hpp"
#include "oracle/numbers/ulp.hpp"

namespace rayproof::oracle {

/// The number rounded to nearest, ties to even, in the case's precision; infinite where it overflows.
template <class Number>
[[nodiscard]] double round_correctly(const Number& number, Precision precision);
extern template double round_correctly(const ExactRoot&, Precision);
extern template double round_correctly(const Quotient&, Precision);

}  // namespace rayproof::oracle
