#pragma once
/// \file
/// Small helpers of the methods that are for plain numbers alone.

#include <cmath>
#include <concepts>
#include <rayproof/exact_rounding.hpp>

namespace rayproof {

/// Neither infinite nor NaN. The exact methods ask first: an expansion has no sign for a NaN.
template <std::floating_point T>
[[nodiscard]] inline bool is_finite(T x) {
  return std::isfinite(x);
}
template <std::floating_point T>
[[nodiscard]] inline bool is_finite(const glm::vec<3, T>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// The ratio in T, within 0.501 ulp, where no interval is to be minded.
template <std::floating_point T, std::size_t N, std::size_t M>
[[nodiscard]] T rounded_alone(const ExactRatio<N, M>& ratio) {
  const Ray<T> whole_line{{}, {}, -infinity<T>, infinity<T>};
  return rounded(whole_line, ratio);
}

}  // namespace rayproof
