#pragma once
/// \file
/// Exponents of packs: taken apart and put together in the bits, since the C library has no such function for
/// packs.

#include <bit>
#include <cstdint>
#include <rayproof/arithmetics/pack.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// The bits of a pack's numbers and what stands where in them.
template <class T, class Abi>
struct PackBits {
  using Number = Pack<T, Abi>;
  using Word = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  using Words = std::experimental::rebind_simd_t<Word, typename Number::Lanes>;

  static constexpr int fraction_bits = std::numeric_limits<T>::digits - 1;
  static constexpr int bias = std::numeric_limits<T>::max_exponent - 1;
  static constexpr int smallest_normal = std::numeric_limits<T>::min_exponent - 1;
  /// A small whole number added to this one stands in the low bits of the sum.
  static constexpr T shifter = T(1) / std::numeric_limits<T>::epsilon();

  static Words words(const Number& x) { return std::bit_cast<Words>(x.lanes()); }
  static Number number(const Words& x) { return Number(std::bit_cast<typename Number::Lanes>(x)); }

  /// 2^e for a whole number e from `smallest_normal` to `bias`.
  static Number power_of_two(const Number& e) {
    return number(words(e + Number(bias) + Number(shifter)) << fraction_bits);
  }

  /// The exponent field of a number that is not negative, as a number.
  static Number exponent_field(const Number& x) {
    return number((words(x) >> fraction_bits) | words(Number(shifter))) - Number(shifter);
  }
};

template <class T, class Abi>
[[nodiscard]] Pack<T, Abi> exponent(const Pack<T, Abi>& x) {
  using N = Pack<T, Abi>;
  using Bits = PackBits<T, Abi>;
  const N magnitude = abs(x);
  const auto subnormal = magnitude < N(std::numeric_limits<T>::min());
  const N normal = select(subnormal, magnitude * N(Bits::shifter), magnitude);
  const N shift = select(subnormal, N(Bits::bias + Bits::fraction_bits), N(Bits::bias));
  const N e = select(magnitude == N(0), N(-infinity<T>), Bits::exponent_field(normal) - shift);
  return select(magnitude < N(infinity<T>), e, magnitude);
}

/// Three multiplications, of which only the last can round: a step down leaves the fraction's width of room
/// above the subnormals, and what has too little room even so ends as 0 in any case.
template <class T, class Abi>
[[nodiscard]] Pack<T, Abi> scale_exponent(const Pack<T, Abi>& x, const Pack<T, Abi>& e) {
  using N = Pack<T, Abi>;
  using Bits = PackBits<T, Abi>;
  const N top(Bits::bias);
  const N bottom(Bits::smallest_normal);
  const N step_down(Bits::smallest_normal + std::numeric_limits<T>::digits);
  N left = max(bottom + N(2) * step_down, min(N(3) * top, e));
  N scaled = x;
  for (int i = 0; i < 2; ++i) {
    const N step = select(left > top, top, select(left < bottom, step_down, N(0)));
    scaled = scaled * Bits::power_of_two(step);
    left = left - step;
  }
  return scaled * Bits::power_of_two(left);
}

/// With x = 2^e·(1 + m), 0 <= m < 1, taking its bits from those of 2^0 twice over gives 2^-e·(1 - m/2), which
/// is (1 + m·(1 - m)/2)/x.
template <class T, class Abi>
[[nodiscard]] Pack<T, Abi> reciprocal_bound(const Pack<T, Abi>& x) {
  using Bits = PackBits<T, Abi>;
  using Word = typename Bits::Word;
  return Bits::number(typename Bits::Words(Word{2 * Bits::bias} << Word{Bits::fraction_bits}) -
                      Bits::words(x));
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
