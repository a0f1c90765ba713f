#pragma once
/// \file
/// Comparing numbers bit for bit.

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <type_traits>

namespace rayproof {

/// The same bits, so that -0 is not 0; any NaN is as good as another.
template <std::floating_point T>
[[nodiscard]] bool same_bits(T x, T y) {
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  return (std::isnan(x) && std::isnan(y)) || std::bit_cast<Bits>(x) == std::bit_cast<Bits>(y);
}

}  // namespace rayproof
