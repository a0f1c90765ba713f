#pragma once
/// \file
/// A pack of floats in double, between whose numbers products are exact: twice the registers.

#include <rayproof/arithmetics/pack.hpp>
#include <utility>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// The float lanes of a pack of doubles, and back.
template <class Wide>
using FloatLanes = typename CompilerVector<float, Wide::size>::type;
template <class T, class Abi>
[[nodiscard]] FloatLanes<Pack<T, Abi>> float_lanes(const Pack<T, Abi>& x) {
  using Doubles = typename CompilerVector<double, Pack<T, Abi>::size>::type;
  return __builtin_convertvector(std::bit_cast<Doubles>(x.lanes()), FloatLanes<Pack<T, Abi>>);
}
template <class Wide>
[[nodiscard]] Wide from_float_lanes(const FloatLanes<Wide>& x) {
#ifdef __AVX512F__
  // g++ 12 widens the halves one by one.
  if constexpr (Wide::size == 8) {
    return typename Wide::Lanes(_mm512_cvtps_pd(std::bit_cast<__m256>(x)));
  }
#endif
  using Doubles = typename CompilerVector<double, Wide::size>::type;
  return std::bit_cast<typename Wide::Lanes>(__builtin_convertvector(x, Doubles));
}

/// Reads as many consecutive floats as the pack of doubles has lanes.
template <class Wide>
[[nodiscard]] Wide load_floats(const float* from) {
  FloatLanes<Wide> x;
  __builtin_memcpy(&x, from, sizeof x);
  return from_float_lanes<Wide>(x);
}
/// Writes the lanes to as many floats, each rounded once.
template <class Wide>
void store_floats(const Wide& x, float* to) {
  const FloatLanes<Wide> rounded = float_lanes(x);
  __builtin_memcpy(to, &rounded, sizeof rounded);
}

template <std::same_as<double> T, class Abi>
[[nodiscard]] Pack<T, Abi> to_nearest_float(const Pack<T, Abi>& x) {
  return from_float_lanes<Pack<T, Abi>>(float_lanes(x));
}

/// The lanes of a `Pack<float, Abi>` in double, the first half and the second half of them.
template <class Abi>
class WidePack {
  using Narrow = Pack<float, Abi>;
  static constexpr std::size_t half = Narrow::size / 2;
  using Half = Pack<double, std::experimental::simd_abi::deduce_t<double, half>>;
  using Floats = typename CompilerVector<float, 2 * half>::type;
  using Doubles = typename CompilerVector<double, half>::type;

 public:
  using Plain = double;

  WidePack() = default;
  explicit WidePack(const Narrow& x)
      : first_(part<0>(x, std::make_index_sequence<half>())),
        second_(part<half>(x, std::make_index_sequence<half>())) {}
  /// The same number in every lane.
  explicit WidePack(double same) : first_(same), second_(same) {}

  /// Reads as many consecutive floats as there are lanes: from memory widening is one step.
  [[nodiscard]] static WidePack load(const float* from) {
    return {load_floats<Half>(from), load_floats<Half>(from + half)};
  }

  friend WidePack operator*(const WidePack& a, const WidePack& b) {
    return {a.first_ * b.first_, a.second_ * b.second_};
  }
  friend WidePack operator+(const WidePack& a, const WidePack& b) {
    return {a.first_ + b.first_, a.second_ + b.second_};
  }
  friend WidePack operator-(const WidePack& a, const WidePack& b) {
    return {a.first_ - b.first_, a.second_ - b.second_};
  }
  friend WidePack operator-(const WidePack& a) { return {-a.first_, -a.second_}; }
  friend WidePack abs(const WidePack& a) { return {abs(a.first_), abs(a.second_)}; }

  /// One bool for each lane, in the two halves.
  struct Lanes {
    rayproof::Mask<Half> first, second;
  };
  friend Lanes operator<(const WidePack& a, const WidePack& b) {
    return {a.first_ < b.first_, a.second_ < b.second_};
  }
  friend WidePack select(const Lanes& mask, const WidePack& yes, const WidePack& no) {
    return {select(mask.first, yes.first_, no.first_), select(mask.second, yes.second_, no.second_)};
  }

  friend WidePack multiply_add(const WidePack& x, const WidePack& y, const WidePack& z) {
    return {multiply_add(x.first_, y.first_, z.first_), multiply_add(x.second_, y.second_, z.second_)};
  }
  friend WidePack sum_of_products(const WidePack& a, const WidePack& b, const WidePack& c, const WidePack& d,
                                  const WidePack& e, const WidePack& f) {
    return multiply_add(e, f, multiply_add(c, d, a * b));
  }

  /// Each lane rounded to float once.
  friend Narrow narrow(const WidePack& x) { return joined(x, std::make_index_sequence<2 * half>()); }

 private:
  WidePack(const Half& first, const Half& second) : first_(first), second_(second) {}

  template <std::size_t from, std::size_t... i>
  static Half part(const Narrow& x, std::index_sequence<i...> /*lanes*/) {
    const auto all = std::bit_cast<Floats>(x.lanes());
    const auto some = __builtin_shufflevector(all, all, int{from + i}...);
    return from_float_lanes<Half>(some);
  }

  template <std::size_t... i>
  static Narrow joined(const WidePack& x, std::index_sequence<i...> /*lanes*/) {
    const auto floats = [](const Half& part) {
      return __builtin_convertvector(std::bit_cast<Doubles>(part.lanes()),
                                     typename CompilerVector<float, half>::type);
    };
    const auto all = __builtin_shufflevector(floats(x.first_), floats(x.second_), int{i}...);
    return std::bit_cast<typename Narrow::Lanes>(all);
  }

  Half first_, second_;
};

template <class Abi>
[[nodiscard]] WidePack<Abi> widen(const Pack<float, Abi>& x) {
  return WidePack<Abi>(x);
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
