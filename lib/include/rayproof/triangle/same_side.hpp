#pragma once
#include <rayproof/arithmetic.hpp>

namespace rayproof::triangle {

/// Whether the ray passes all three edges on the same side or on them: none of the numbers is of the other
/// sign. False where one is NaN, true where all are 0.
template <class T>
[[nodiscard]] constexpr Mask<T> same_side(const T& U, const T& V, const T& W) {
  return (U >= T(0) && V >= T(0) && W >= T(0)) || (U <= T(0) && V <= T(0) && W <= T(0));
}

}  // namespace rayproof::triangle
