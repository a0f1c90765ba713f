#pragma once
/// \file
/// The arithmetic of many numbers at once: one lane per ray, every lane rounded as the scalar kernel rounds.

#include <bit>
#include <concepts>
#include <cstddef>
#include <rayproof/arithmetic.hpp>
#include <type_traits>

#if defined(__GNUC__) && !defined(__clang__)
// GCC 12 warns of its own AVX-512 intrinsics, whose undefined operands are meant so (GCC bug 105593).
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <experimental/simd>
#pragma GCC diagnostic pop
#else
#include <experimental/simd>
#endif

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// The compiler's own vector, because the library's casts go through memory.
template <class T, std::size_t size>
struct CompilerVector {
  using type [[gnu::vector_size(size * sizeof(T))]] = T;
};

/// As many `T` as a register of the instruction set holds that this source is compiled for. The width is part
/// of the type, so that code for two instruction sets is never mistaken for the same code by the linker.
///
/// A class of our own around std::experimental::native_simd, because the kernels write T(4) and T(-0.5), and
/// because the vocabulary of arithmetic.hpp is found through the number's own namespace.
template <std::floating_point T, class Abi = std::experimental::simd_abi::native<T>>
class Pack : public Comparable<Pack<T, Abi>> {
 public:
  using Plain = T;
  using Lanes = std::experimental::simd<T, Abi>;
  static constexpr std::size_t size = Lanes::size();

  Pack() = default;
  Pack(Lanes lanes) : lanes_(lanes) {}
  /// The same number in every lane.
  template <class Number>
  requires std::is_arithmetic_v<Number>
  explicit Pack(Number same) : lanes_(static_cast<T>(same)) {}

  /// Reads `size` consecutive numbers, of any alignment.
  [[nodiscard]] static Pack load(const T* from) { return Lanes(from, std::experimental::element_aligned); }
  /// Writes the lanes to `size` consecutive numbers, of any alignment.
  void store(T* to) const { lanes_.copy_to(to, std::experimental::element_aligned); }

  [[nodiscard]] const Lanes& lanes() const { return lanes_; }

  friend Pack operator+(const Pack& a, const Pack& b) { return a.lanes_ + b.lanes_; }
  friend Pack operator-(const Pack& a, const Pack& b) { return a.lanes_ - b.lanes_; }
  friend Pack operator*(const Pack& a, const Pack& b) { return a.lanes_ * b.lanes_; }
  friend Pack operator/(const Pack& a, const Pack& b) { return a.lanes_ / b.lanes_; }
  friend Pack operator-(const Pack& a) { return -a.lanes_; }
  friend auto operator<(const Pack& a, const Pack& b) { return a.lanes_ < b.lanes_; }
  friend auto operator<=(const Pack& a, const Pack& b) { return a.lanes_ <= b.lanes_; }
  friend auto operator==(const Pack& a, const Pack& b) { return a.lanes_ == b.lanes_; }

 private:
  Lanes lanes_{};
};

template <class T, class Abi>
[[nodiscard]] Pack<T, Abi> select(const std::type_identity_t<Mask<Pack<T, Abi>>>& mask,
                                  const Pack<T, Abi>& yes, const Pack<T, Abi>& no) {
  using Lanes = typename Pack<T, Abi>::Lanes;
#if defined(__clang__) && defined(__AVX512F__)
  // Under clang, libstdc++ 12 takes an AVX-512 mask for one bool ("FIXME" in its _S_blend_avx512).
  if constexpr (sizeof(Lanes) == 64) {
    const auto bits = std::experimental::__data(mask)._M_data;
    if constexpr (sizeof(T) == 4) {
      return Lanes(
          _mm512_mask_blend_ps(bits, static_cast<__m512>(no.lanes()), static_cast<__m512>(yes.lanes())));
    } else {
      return Lanes(
          _mm512_mask_blend_pd(bits, static_cast<__m512d>(no.lanes()), static_cast<__m512d>(yes.lanes())));
    }
  }
#endif
  Lanes chosen = no.lanes();
  where(mask, chosen) = yes.lanes();
  return chosen;
}

template <class T, class Abi>
[[nodiscard]] Pack<T, Abi> sqrt(const Pack<T, Abi>& x) {
  return std::experimental::sqrt(x.lanes());
}

template <class T, class Abi>
[[nodiscard]] Pack<T, Abi> abs(const Pack<T, Abi>& x) {
  return std::experimental::abs(x.lanes());
}

template <class T, class Abi>
[[nodiscard]] Pack<T, Abi> copysign(const Pack<T, Abi>& x, const Pack<T, Abi>& sign) {
  return std::experimental::copysign(x.lanes(), sign.lanes());
}

/// The smaller in each lane. Where AVX-512 compares into a mask, g++ 12 does not see that the comparison and
/// the choice are one instruction, which gives its second operand where they are equal or one is NaN.
template <class T, class Abi>
[[nodiscard]] Pack<T, Abi> min(const Pack<T, Abi>& x, const Pack<T, Abi>& y) {
#ifdef __AVX512F__
  using Lanes = typename Pack<T, Abi>::Lanes;
  if constexpr (std::same_as<Lanes, std::experimental::native_simd<float>>) {
    return Lanes(_mm512_min_ps(static_cast<__m512>(y.lanes()), static_cast<__m512>(x.lanes())));
  } else if constexpr (std::same_as<Lanes, std::experimental::native_simd<double>>) {
    return Lanes(_mm512_min_pd(static_cast<__m512d>(y.lanes()), static_cast<__m512d>(x.lanes())));
  }
#endif
  return select(y < x, y, x);
}

/// The larger in each lane, as `min`.
template <class T, class Abi>
[[nodiscard]] Pack<T, Abi> max(const Pack<T, Abi>& x, const Pack<T, Abi>& y) {
#ifdef __AVX512F__
  using Lanes = typename Pack<T, Abi>::Lanes;
  if constexpr (std::same_as<Lanes, std::experimental::native_simd<float>>) {
    return Lanes(_mm512_max_ps(static_cast<__m512>(y.lanes()), static_cast<__m512>(x.lanes())));
  } else if constexpr (std::same_as<Lanes, std::experimental::native_simd<double>>) {
    return Lanes(_mm512_max_pd(static_cast<__m512d>(y.lanes()), static_cast<__m512d>(x.lanes())));
  }
#endif
  return select(x < y, y, x);
}

/// One fused instruction where the instruction set has it, else the C library's function lane by lane. The
/// instructions by name, since flags keep the compiler from gathering them from the lanes (as_written.hpp).
template <class T, class Abi>
[[nodiscard]] Pack<T, Abi> fma(const Pack<T, Abi>& x, const Pack<T, Abi>& y, const Pack<T, Abi>& z) {
  using Lanes = typename Pack<T, Abi>::Lanes;
#ifdef __AVX512F__
  if constexpr (std::same_as<Lanes, std::experimental::native_simd<float>>) {
    return Lanes(_mm512_fmadd_ps(static_cast<__m512>(x.lanes()), static_cast<__m512>(y.lanes()),
                                 static_cast<__m512>(z.lanes())));
  } else if constexpr (std::same_as<Lanes, std::experimental::native_simd<double>>) {
    return Lanes(_mm512_fmadd_pd(static_cast<__m512d>(x.lanes()), static_cast<__m512d>(y.lanes()),
                                 static_cast<__m512d>(z.lanes())));
  }
#elif defined __FMA__ && defined __AVX__
  if constexpr (std::same_as<Lanes, std::experimental::native_simd<float>>) {
    return Lanes(_mm256_fmadd_ps(static_cast<__m256>(x.lanes()), static_cast<__m256>(y.lanes()),
                                 static_cast<__m256>(z.lanes())));
  } else if constexpr (std::same_as<Lanes, std::experimental::native_simd<double>>) {
    return Lanes(_mm256_fmadd_pd(static_cast<__m256d>(x.lanes()), static_cast<__m256d>(y.lanes()),
                                 static_cast<__m256d>(z.lanes())));
  }
#endif
  return Lanes([&](auto lane) {
    // The compiler's built-in, because an inline std::fma compiled here could be linked into code for older
    // machines.
    if constexpr (std::same_as<T, float>) {
      return __builtin_fmaf(x.lanes()[lane], y.lanes()[lane], z.lanes()[lane]);
    } else {
      return __builtin_fma(x.lanes()[lane], y.lanes()[lane], z.lanes()[lane]);
    }
  });
}

/// Fused where the instruction set can.
template <class T, class Abi>
[[nodiscard]] Pack<T, Abi> multiply_add(const Pack<T, Abi>& x, const Pack<T, Abi>& y, const Pack<T, Abi>& z) {
#ifdef __FMA__
  return fma(x, y, z);
#else
  return x * y + z;
#endif
}

/// Whether the compiler sees that all lanes are 0. It looks at the first: a number that is known is in all
/// lanes.
template <class T, class Abi>
[[nodiscard]] bool is_known_zero(const Pack<T, Abi>& x) {
  const auto lanes = std::bit_cast<typename CompilerVector<T, Pack<T, Abi>::size>::type>(x.lanes());
  return is_known_zero(T{lanes[0]});
}

/// Adding and taking away 2^(digits-1) rounds to a whole number; larger numbers are whole already.
template <class T, class Abi>
[[nodiscard]] Pack<T, Abi> floor(const Pack<T, Abi>& x) {
  using N = Pack<T, Abi>;
  const N all_whole(T(1) / std::numeric_limits<T>::epsilon());
  const N magnitude = abs(x);
  const N whole = copysign((magnitude + all_whole) - all_whole, x);
  const N below = whole - select(whole > x, N(1), N(0));
  return select(magnitude < all_whole, below, x);
}

}  // namespace rayproof

#include <rayproof/arithmetics/pack_exponent.hpp>
#include <rayproof/arithmetics/pack_wide.hpp>

#include <rayproof/rounding/as_before.hpp>
