#pragma once
/// \file
/// A pack of floats in double, between whose numbers products are exact: twice the registers.

#include <bit>
#include <rayproof/arithmetics/pack.hpp>
#include <utility>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// The lanes of a `Pack<float, Abi>` in double, the first half and the second half of them.
template <class Abi>
class WidePack {
  using Narrow = Pack<float, Abi>;
  static constexpr std::size_t half = Narrow::size / 2;
  using Half = Pack<double, std::experimental::simd_abi::deduce_t<double, half>>;
  // The compiler's own vectors, because the library's casts go through memory.
  template <class T, std::size_t size>
  struct CompilerVector {
    using type [[gnu::vector_size(size * sizeof(T))]] = T;
  };
  using Floats = typename CompilerVector<float, 2 * half>::type;
  using Doubles = typename CompilerVector<double, half>::type;

 public:
  explicit WidePack(const Narrow& x)
      : first_(part<0>(x, std::make_index_sequence<half>())),
        second_(part<half>(x, std::make_index_sequence<half>())) {}

  friend WidePack operator*(const WidePack& a, const WidePack& b) {
    return {a.first_ * b.first_, a.second_ * b.second_};
  }
  friend WidePack operator-(const WidePack& a, const WidePack& b) {
    return {a.first_ - b.first_, a.second_ - b.second_};
  }

  /// Each lane rounded to float once.
  friend Narrow narrow(const WidePack& x) { return joined(x, std::make_index_sequence<2 * half>()); }

 private:
  WidePack(const Half& first, const Half& second) : first_(first), second_(second) {}

  template <std::size_t from, std::size_t... i>
  static Half part(const Narrow& x, std::index_sequence<i...> /*lanes*/) {
    const auto all = std::bit_cast<Floats>(x.lanes());
    const auto some = __builtin_shufflevector(all, all, int{from + i}...);
    return std::bit_cast<typename Half::Lanes>(__builtin_convertvector(some, Doubles));
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
