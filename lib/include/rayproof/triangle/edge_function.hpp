#pragma once
/// \file
/// Edge functions: on which side of an edge a ray passes.

#include <rayproof/arithmetic.hpp>
#include <rayproof/formulas/difference_of_products.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::triangle {

/// ab - cd with its exact sign, 0 included.
///
/// In an arithmetic of floats by exact products in double, in one of doubles by fused multiply-adds, as long
/// as nothing underflows: in floats a result below 2^-150 in magnitude is rounded to 0.
template <class T>
[[nodiscard]] constexpr T edge_function(const T& a, const T& b, const T& c, const T& d) {
  if constexpr (digits<T> == digits<float>) {
    return narrow(widen(a) * widen(b) - widen(c) * widen(d));
  } else {
    return difference_of_products(a, b, c, d);
  }
}

/// Whether the ray passes all three edges on the same side or on them: none of the numbers is of the other
/// sign. False where one is NaN, true where all are 0.
template <class T>
[[nodiscard]] constexpr Mask<T> same_side(const T& U, const T& V, const T& W) {
  return (U >= T(0) && V >= T(0) && W >= T(0)) || (U <= T(0) && V <= T(0) && W <= T(0));
}

}  // namespace rayproof::triangle

#include <rayproof/rounding/as_before.hpp>
