#pragma once
#include <rayproof/arithmetic.hpp>
#include <rayproof/formulas/difference_of_products.hpp>

namespace rayproof::triangle {

/// ab - cd with its exact sign, 0 included.
///
/// In an arithmetic of floats by exact products in double, whatever the size of the floats; in one of doubles
/// by fused multiply-adds, as long as nothing underflows.
template <class T>
[[nodiscard]] constexpr T edge_function(const T& a, const T& b, const T& c, const T& d) {
  if constexpr (digits<T> == digits<float>) {
    return narrow(widen(a) * widen(b) - widen(c) * widen(d));
  } else {
    return difference_of_products(a, b, c, d);
  }
}

}  // namespace rayproof::triangle
