#pragma once
/// \file
/// Running error analysis: every number carries a bound on its own error, computed beside it.
///
/// Source: J. H. Wilkinson's a-posteriori analysis as presented by N. J. Higham, "Accuracy and Stability of
/// Numerical Algorithms", ch. 3.3, 2002; here with underflow, overflow and uncertain comparisons.

#include <algorithm>
#include <concepts>
#include <limits>
#include <rayproof/arithmetic.hpp>
#include <type_traits>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// A comparison's outcome, and whether the exact numbers are sure to compare in the same way.
struct BoundedMask {
  bool value = false;
  bool certain = true;
  // A plain outcome is a certain one, and the value is the outcome.
  // NOLINTNEXTLINE(google-explicit-constructor)
  constexpr BoundedMask(bool outcome, bool sure = true) : value(outcome), certain(sure) {}
  // NOLINTNEXTLINE(google-explicit-constructor): so that masks stand where the kernels have a bool
  constexpr operator bool() const { return value; }

  friend constexpr BoundedMask operator!(BoundedMask m) { return {!m.value, m.certain}; }
  friend constexpr BoundedMask operator&&(BoundedMask a, BoundedMask b) {
    return {a.value && b.value,
            (a.certain && b.certain) || (a.certain && !a.value) || (b.certain && !b.value)};
  }
  friend constexpr BoundedMask operator||(BoundedMask a, BoundedMask b) { return !(!a && !b); }
};

namespace running_error {

template <class T>
inline constexpr T unit = std::numeric_limits<T>::epsilon() / 2;
template <class T>
inline constexpr T tiny = std::numeric_limits<T>::denorm_min();

/// Outweighs the roundings made in computing a bound itself: a sum of at most eight positive products.
template <std::floating_point T>
[[nodiscard]] constexpr T up(T bound) {
  return bound * (1 + 32 * unit<T>);
}

/// Bounds the rounding error of a sum whose rounded value is z; sums below 2·min are exact.
template <std::floating_point T>
[[nodiscard]] T of_sum(T z) {
  return std::abs(z) < 2 * std::numeric_limits<T>::min() ? T(0) : unit<T> * std::abs(z) + tiny<T>;
}

/// Bounds the rounding error of a product or quotient z, and what underflow took from the terms of its bound.
template <std::floating_point T>
[[nodiscard]] T of_product(T z) {
  return unit<T> * std::abs(z) + 4 * tiny<T>;
}

}  // namespace running_error

/// A number of type `T` and a bound on its error: |value - exact| <= error, where *exact* is what the formula
/// gives for the exact inputs in real numbers. The bound is infinite where nothing can be said: NaN,
/// overflow, a divisor that may be 0. Where a root's radicand may be negative, the bound holds if the exact
/// one is not.
///
/// Rounds bit for bit as `T` does. Comparisons and `select` follow the values; where the exact numbers might
/// choose the other branch, the bound covers that branch too.
template <std::floating_point T>
struct Bounded : Comparable<Bounded<T>> {
  using Plain = T;

  T value{};
  T error{};

  constexpr Bounded() = default;
  constexpr Bounded(T rounded, T bound) : value(rounded), error(bound) {}
  /// An exact number, or the nearest `T` to one with the error of that.
  template <class U>
  requires std::is_arithmetic_v<U>
  // NOLINTNEXTLINE(google-explicit-constructor): kernels mix plain numbers in, as formulas do
  constexpr Bounded(U exact) : value(static_cast<T>(exact)) {
    const auto back = static_cast<double>(value);
    const auto wide = static_cast<double>(exact);
    if (back != wide) error = running_error::up(static_cast<T>(back < wide ? wide - back : back - wide));
    if (value != value) error = infinity<T>;
  }

  /// A rounded value and a bound, infinite where either is not finite.
  [[nodiscard]] static Bounded of(T value, T bound) {
    const bool is_bounded = std::isfinite(value) && std::isfinite(bound);
    return {value, is_bounded ? running_error::up(bound) : infinity<T>};
  }

  [[nodiscard]] bool is_exact_zero() const { return value == 0 && error == 0; }
  [[nodiscard]] bool may_be_zero() const { return !(std::abs(value) > error); }

  friend Bounded operator-(const Bounded& x) { return {-x.value, x.error}; }
  friend Bounded operator+(const Bounded& x, const Bounded& y) {
    const T z = x.value + y.value;
    return of(z, x.error + y.error + running_error::of_sum(z));
  }
  friend Bounded operator-(const Bounded& x, const Bounded& y) { return x + (-y); }
  friend Bounded operator*(const Bounded& x, const Bounded& y) {
    const T z = x.value * y.value;
    if ((x.is_exact_zero() || y.is_exact_zero()) && z == 0) return Bounded(z);
    return of(z, spread_of_product(x, y) + running_error::of_product(z));
  }
  /// X/Y - x/y = ((X - x) - (x/y)(Y - y)) / Y.
  friend Bounded operator/(const Bounded& x, const Bounded& y) {
    const T z = x.value / y.value;
    if (y.may_be_zero()) return of(z, infinity<T>);
    if (x.is_exact_zero()) return Bounded(z);
    const T numerator = x.error + (std::abs(z) + 2 * running_error::tiny<T>)*y.error;
    const bool is_exact = x.error == 0 && y.error == 0;
    const T lost_to_underflow = is_exact ? T(0) : 2 * running_error::tiny<T>;
    const T spread = (numerator + lost_to_underflow) / (std::abs(y.value) - y.error);
    return of(z, spread + running_error::of_product(z));
  }

  friend BoundedMask operator<(const Bounded& x, const Bounded& y) {
    return {x.value < y.value, apart(x, y)};
  }
  friend BoundedMask operator<=(const Bounded& x, const Bounded& y) {
    return {x.value <= y.value, apart(x, y)};
  }
  friend BoundedMask operator==(const Bounded& x, const Bounded& y) {
    return {x.value == y.value, apart(x, y)};
  }

  /// How far the errors of the factors can move their product.
  [[nodiscard]] static T spread_of_product(const Bounded& x, const Bounded& y) {
    return std::abs(x.value) * y.error + std::abs(y.value) * x.error + x.error * y.error;
  }
  /// Whether the exact numbers compare as the values do.
  [[nodiscard]] static bool apart(const Bounded& x, const Bounded& y) {
    if (x.error == 0 && y.error == 0) return true;
    return std::abs(x.value - y.value) > running_error::up(running_error::up(x.error + y.error));
  }
};

}  // namespace rayproof

#include <rayproof/arithmetics/bounded_functions.hpp>  // IWYU pragma: export

#include <rayproof/rounding/as_before.hpp>
