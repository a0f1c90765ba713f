#pragma once
/// \file
/// Unit vectors.

#include <rayproof/arithmetic.hpp>
#include <rayproof/vec3.hpp>

namespace rayproof {

/// v / |v|; NaN where v is 0.
template <class T>
[[nodiscard]] vec3<T> normalized(const vec3<T>& v) {
  return (T(1) / sqrt(dot(v, v))) * v;
}

}  // namespace rayproof
