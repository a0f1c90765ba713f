#pragma once
/// \file
/// Error-free transformations: a sum or a product as its rounded value and the rounding error, exactly.

#include <rayproof/arithmetic.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// `rounded + rest` is the exact result, unless something over- or underflowed.
template <class T>
struct ErrorFree {
  T rounded;
  T rest;
};

/// x + y (D. E. Knuth, The Art of Computer Programming 2, 4.2.2, 1969).
template <class T>
[[nodiscard]] constexpr ErrorFree<T> two_sum(const T& x, const T& y) {
  const T sum = x + y;
  const T y_part = sum - x;
  return {sum, (x - (sum - y_part)) + (y - y_part)};
}

/// x * y by a fused multiply-add.
template <class T>
[[nodiscard]] constexpr ErrorFree<T> two_product(const T& x, const T& y) {
  const T product = x * y;
  return {product, fma(x, y, -product)};
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
