#pragma once
/// \file
/// The square, which an arithmetic may know better than as a product.

namespace rayproof {

/// x·x. An interval brings its own, which knows that no square is negative.
template <class T>
[[nodiscard]] constexpr T square(const T& x) {
  return x * x;
}

}  // namespace rayproof
