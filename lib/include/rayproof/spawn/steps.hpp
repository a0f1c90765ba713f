#pragma once
/// \file
/// Steps along the floating-point numbers, taken in their bits: for plain numbers and for packs.

#include <bit>
#include <cstdint>
#include <rayproof/arithmetics/pack_exponent.hpp>
#include <type_traits>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::spawn {

/// `x` moved by |k| numbers of its format, towards larger ones for k > 0, to smaller ones for k < 0; k is a
/// whole number below 2^20; any other gives NaN. A number that steps over 0 goes wrong, as the published code
/// does.
template <std::floating_point T>
[[nodiscard]] constexpr T moved_by_steps(T x, T k) {
  using Steps = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
  using Word = std::make_unsigned_t<Steps>;  // one step down from -0 leaves the numbers, and must be defined
  if (!(abs(k) < T(0x1p20))) return not_a_number<T>;  // as where a normal is NaN
  const auto steps = static_cast<Steps>(x < T(0) ? -k : k);
  return std::bit_cast<T>(std::bit_cast<Word>(x) + static_cast<Word>(steps));
}
template <class T, class Abi>
[[nodiscard]] Pack<T, Abi> moved_by_steps(const Pack<T, Abi>& x, const Pack<T, Abi>& k) {
  using N = Pack<T, Abi>;
  using Bits = PackBits<T, Abi>;
  const N steps = select(x < N(0), -k, k);
  const auto size = Bits::words(abs(steps) + N(Bits::shifter)) - Bits::words(N(Bits::shifter));
  const N moved =
      select(steps < N(0), Bits::number(Bits::words(x) - size), Bits::number(Bits::words(x) + size));
  return select(abs(k) < N(0x1p20), moved, N(not_a_number<N>));
}

/// Whether an arithmetic has bits to step along.
template <class T>
concept HasSteps = requires(const T& x) {
  moved_by_steps(x, x);
};

}  // namespace rayproof::spawn

#include <rayproof/rounding/as_before.hpp>
