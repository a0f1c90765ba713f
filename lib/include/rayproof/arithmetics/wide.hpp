#pragma once
/// \file
/// An arithmetic that rounds in float, widened to double and narrowed again: between the two, the product of
/// two floats is exact. Arithmetics that round in double have nothing wider.

#include <array>
#include <concepts>
#include <cstddef>
#include <rayproof/arithmetic.hpp>

namespace rayproof {

// Only named here: who uses one of them brings its header.
template <std::floating_point T, class Abi>
class Pack;
template <std::floating_point T>
struct Bounded;
template <std::floating_point T, class Shadow>
struct Recorded;

/// `widen` gives the same number in double, exactly; `narrow` rounds a number in double once.
template <class T>
struct Wide {
  static constexpr bool exists = false;
};

template <>
struct Wide<float> {
  static constexpr bool exists = true;
  static constexpr double widen(float x) { return x; }
  static constexpr float narrow(double x) { return static_cast<float>(x); }
};

/// `double`, looked up only once F is known, so that an arithmetic may stay incomplete here.
template <std::same_as<float> F>
struct DoubleFor {
  using type = double;
};
template <class F>
using Double = typename DoubleFor<F>::type;

template <std::same_as<float> F>
struct Wide<Bounded<F>> {
  static constexpr bool exists = true;
  static Bounded<Double<F>> widen(const Bounded<F>& x) {
    Bounded<Double<F>> wide;
    wide.value = x.value;
    wide.error = x.error;
    return wide;
  }
  static Bounded<F> narrow(const Bounded<Double<F>>& x) {
    const F value = static_cast<F>(x.value);
    const double error = x.error + abs(x.value - value);
    if (error == 0) return Bounded<F>::of(value, 0);
    // Rounded to float the bound may shrink, by less than the factor and the term make up for.
    return Bounded<F>::of(value,
                          static_cast<F>(error * (1 + 0x1p-22)) + std::numeric_limits<F>::denorm_min());
  }
};

/// The same operation on the tape, in double: what widens and narrows a number is no step of the formula.
template <std::same_as<float> F, class Shadow>
struct Wide<Recorded<F, Shadow>> {
  static constexpr bool exists = true;
  static Recorded<Double<F>, Shadow> widen(const Recorded<F, Shadow>& x) {
    Recorded<Double<F>, Shadow> wide;
    wide.bounded = Wide<Bounded<F>>::widen(x.bounded);
    wide.exact = x.exact;
    wide.id = x.id;
    return wide;
  }
  static Recorded<F, Shadow> narrow(const Recorded<Double<F>, Shadow>& x) {
    Recorded<F, Shadow> narrow;
    narrow.bounded = Wide<Bounded<F>>::narrow(x.bounded);
    narrow.exact = x.exact;
    narrow.id = x.id;
    return narrow;
  }
};

/// The lanes of a pack of floats, in double. A plain array: no register of the instruction set holds them
/// all, and the type still distinguishes instruction sets.
template <class Abi, std::size_t size>
struct WideLanes {
  std::array<double, size> lanes;

  friend WideLanes operator*(const WideLanes& a, const WideLanes& b) {
    WideLanes product;
    for (std::size_t i = 0; i < size; ++i) product.lanes[i] = a.lanes[i] * b.lanes[i];
    return product;
  }
  friend WideLanes operator-(const WideLanes& a, const WideLanes& b) {
    WideLanes difference;
    for (std::size_t i = 0; i < size; ++i) difference.lanes[i] = a.lanes[i] - b.lanes[i];
    return difference;
  }
};

template <std::same_as<float> F, class Abi>
struct Wide<Pack<F, Abi>> {
  static constexpr bool exists = true;
  template <class P>
  static auto widen(const P& x) {
    F narrow[P::size];
    x.store(narrow);
    WideLanes<Abi, P::size> wide;
    for (std::size_t i = 0; i < P::size; ++i) wide.lanes[i] = narrow[i];
    return wide;
  }
  template <std::size_t size>
  static auto narrow(const WideLanes<Abi, size>& x) {
    F narrow[size];
    for (std::size_t i = 0; i < size; ++i) narrow[i] = static_cast<F>(x.lanes[i]);
    return Pack<F, Abi>::load(narrow);
  }
};

}  // namespace rayproof
