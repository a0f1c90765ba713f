#pragma once
#include <rayproof/arithmetic.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// ab - cd with no cancellation of rounding errors: within 1.5 ulp of the exact value where nothing over- or
/// underflows, hence of the right sign, 0 included.
///
/// Source: W. Kahan's algorithm; bound by C.-P. Jeannerod, N. Louvet, J.-M. Muller, "Further analysis of
/// Kahan's algorithm for the accurate computation of 2×2 determinants", 2013.
template <class T>
[[nodiscard]] constexpr T difference_of_products(const T& a, const T& b, const T& c, const T& d) {
  const T cd = c * d;
  const T rounding_of_cd = fma(-c, d, cd);
  return fma(a, b, -cd) + rounding_of_cd;
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
