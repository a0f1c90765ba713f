#pragma once
/// \file
/// Forward differentiation: a number and its derivative by one variable, computed side by side.
///
/// Source: R. E. Wengert, "A Simple Automatic Derivative Evaluation Program", 1964. Over `Interval<T>` both
/// are enclosures over a whole interval of the variable, which is what interval Newton steps ask for.

#include <rayproof/arithmetics/interval.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// `value` and `slope` = d(value)/d(variable). Seed the variable with slope 1; constants have slope 0.
/// Comparisons look at the value.
template <class T>
struct Dual : Comparable<Dual<T>> {
  using Plain = rayproof::Plain<T>;

  T value{};
  T slope{};

  constexpr Dual() = default;
  template <class U>
  requires std::is_arithmetic_v<U>
  // NOLINTNEXTLINE(google-explicit-constructor): kernels mix plain numbers in, as formulas do
  constexpr Dual(U constant) : value(T(constant)), slope(0) {}
  constexpr Dual(const T& v, const T& s) : value(v), slope(s) {}

  friend Dual operator-(const Dual& x) { return {-x.value, -x.slope}; }
  friend Dual operator+(const Dual& x, const Dual& y) { return {x.value + y.value, x.slope + y.slope}; }
  friend Dual operator-(const Dual& x, const Dual& y) { return {x.value - y.value, x.slope - y.slope}; }
  friend Dual operator*(const Dual& x, const Dual& y) {
    return {x.value * y.value, x.slope * y.value + x.value * y.slope};
  }
  /// (x/y)' = (x' - (x/y)·y')/y.
  friend Dual operator/(const Dual& x, const Dual& y) {
    const T quotient = x.value / y.value;
    return {quotient, (x.slope - quotient * y.slope) / y.value};
  }

  friend auto operator<(const Dual& x, const Dual& y) { return x.value < y.value; }
  friend auto operator<=(const Dual& x, const Dual& y) { return x.value <= y.value; }
  friend auto operator==(const Dual& x, const Dual& y) { return x.value == y.value; }
};

template <class T>
[[nodiscard]] Dual<T> square(const Dual<T>& x) {
  return {square(x.value), T(2) * x.value * x.slope};
}

/// (√x)' = x' / (2√x).
template <class T>
[[nodiscard]] Dual<T> sqrt(const Dual<T>& x) {
  const T root = sqrt(x.value);
  return {root, x.slope / (T(2) * root)};
}

template <class M, class T>
[[nodiscard]] Dual<T> select(const M& mask, const Dual<T>& yes, const Dual<T>& no) {
  return {select(mask, yes.value, no.value), select(mask, yes.slope, no.slope)};
}

/// The variable itself, over all of `range`.
template <class T>
[[nodiscard]] Dual<T> variable(const T& range) {
  return {range, T(1)};
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
