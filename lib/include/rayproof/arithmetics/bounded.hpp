#pragma once
/// \file
/// Running error analysis: every number carries a bound on its own error, computed beside it.
///
/// Source: J. H. Wilkinson's a-posteriori analysis as presented by N. J. Higham, "Accuracy and Stability of
/// Numerical Algorithms", ch. 3.3, 2002; here with underflow, overflow and uncertain comparisons.

#include <concepts>
#include <limits>
#include <rayproof/arithmetic.hpp>
#include <type_traits>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// A comparison's outcome, and whether the exact numbers are sure to compare in the same way. `M` is bool, or
/// the mask of a pack.
template <class M>
struct BoundedMaskOf {
  M value{false};
  M certain{true};
  // A plain outcome is a certain one, and the value is the outcome.
  // NOLINTNEXTLINE(google-explicit-constructor)
  constexpr BoundedMaskOf(const M& outcome, const M& sure = M(true)) : value(outcome), certain(sure) {}
  // NOLINTNEXTLINE(google-explicit-constructor): so that masks stand where the kernels have a bool
  constexpr operator bool() const requires std::same_as<M, bool> { return value; }

  friend constexpr BoundedMaskOf operator!(const BoundedMaskOf& m) { return {!m.value, m.certain}; }
  friend constexpr BoundedMaskOf operator&&(const BoundedMaskOf& a, const BoundedMaskOf& b) {
    return {a.value && b.value,
            (a.certain && b.certain) || (a.certain && !a.value) || (b.certain && !b.value)};
  }
  friend constexpr BoundedMaskOf operator||(const BoundedMaskOf& a, const BoundedMaskOf& b) {
    return !(!a && !b);
  }
};
using BoundedMask = BoundedMaskOf<bool>;

namespace running_error {

template <class T>
inline constexpr Plain<T> unit = std::numeric_limits<Plain<T>>::epsilon() / 2;
/// No less than what underflow takes. In double not the least number there is: processors are slow with such.
template <class T>
inline constexpr Plain<T> tiny = std::same_as<Plain<T>, float> ? std::numeric_limits<Plain<T>>::denorm_min()
                                                               : std::numeric_limits<Plain<T>>::min();

/// Outweighs the roundings made in computing a bound itself: a sum of at most eight positive products.
template <class T>
[[nodiscard]] constexpr T up(const T& bound) {
  return bound * T(1 + 32 * unit<T>);
}

/// Bounds the rounding error of a sum whose rounded value is z; sums below 2·min are exact.
template <class T>
[[nodiscard]] T of_sum(const T& z) {
  return select(abs(z) < T(2 * std::numeric_limits<Plain<T>>::min()), T(0), T(unit<T>) * abs(z) + T(tiny<T>));
}

/// Bounds the rounding error of a product or quotient z, and what underflow took from the terms of its bound.
template <class T>
[[nodiscard]] T of_product(const T& z) {
  return T(unit<T>) * abs(z) + T(4 * tiny<T>);
}

}  // namespace running_error

/// A number of type `T`, plain or a pack, and a bound on its error: |value - exact| <= error, where *exact*
/// is what the formula gives for the exact inputs in real numbers. The bound is infinite where nothing can be
/// said: NaN, overflow, a divisor that may be 0. Where a root's radicand may be negative, the bound holds if
/// the exact one is not.
///
/// Rounds bit for bit as `T` does. Comparisons and `select` follow the values; where the exact numbers might
/// choose the other branch, the bound covers that branch too.
template <class T>
struct Bounded : Comparable<Bounded<T>> {
  using Plain = rayproof::Plain<T>;

  T value{};
  T error{};

  constexpr Bounded() = default;
  constexpr Bounded(const T& rounded, const T& bound) : value(rounded), error(bound) {}
  /// An exact number, or the nearest `T` to one with the error of that.
  template <class U>
  requires std::is_arithmetic_v<U>
  // NOLINTNEXTLINE(google-explicit-constructor): kernels mix plain numbers in, as formulas do
  constexpr Bounded(U exact) : value(static_cast<Plain>(exact)), error(Plain(0)) {
    const auto rounded = static_cast<Plain>(exact);
    const auto back = static_cast<double>(rounded);
    const auto wide = static_cast<double>(exact);
    if (back != wide)
      error = T(running_error::up(static_cast<Plain>(back < wide ? wide - back : back - wide)));
    if (rounded != rounded) error = T(infinity<T>);
  }
  /// A pack of exact numbers.
  constexpr explicit Bounded(const T& exact) requires(!std::is_arithmetic_v<T>)
      : value(exact), error(select(exact == exact, T(0), T(infinity<T>))) {}
  /// The same number in all lanes of a pack.
  template <std::same_as<Plain> U>
  requires(!std::is_arithmetic_v<T>) constexpr explicit Bounded(const Bounded<U>& same)
      : value(T(same.value)), error(T(same.error)) {}

  /// A rounded value and a bound, infinite where either is not finite.
  [[nodiscard]] static constexpr Bounded of(const T& value, const T& bound) {
    const Mask<T> is_bounded = abs(value) < T(infinity<T>) && abs(bound) < T(infinity<T>);
    return {value, select(is_bounded, running_error::up(bound), T(infinity<T>))};
  }

  [[nodiscard]] constexpr Mask<T> is_exact_zero() const { return value == T(0) && error == T(0); }
  [[nodiscard]] constexpr Mask<T> may_be_zero() const { return !(abs(value) > error); }

  friend constexpr Bounded operator-(const Bounded& x) { return {-x.value, x.error}; }
  friend constexpr Bounded operator+(const Bounded& x, const Bounded& y) {
    const T z = x.value + y.value;
    return of(z, x.error + y.error + running_error::of_sum(z));
  }
  friend constexpr Bounded operator-(const Bounded& x, const Bounded& y) { return x + (-y); }
  friend constexpr Bounded operator*(const Bounded& x, const Bounded& y) {
    const T z = x.value * y.value;
    const Mask<T> is_exact = (x.is_exact_zero() || y.is_exact_zero()) && z == T(0);
    return {z, select(is_exact, T(0), of(z, spread_of_product(x, y) + running_error::of_product(z)).error)};
  }
  /// X/Y - x/y = ((X - x) - (x/y)(Y - y)) / Y.
  friend constexpr Bounded operator/(const Bounded& x, const Bounded& y) {
    const T z = x.value / y.value;
    const T numerator = x.error + (abs(z) + T(2 * running_error::tiny<T>)) * y.error;
    const Mask<T> is_exact = x.error == T(0) && y.error == T(0);
    const T lost_to_underflow = select(is_exact, T(0), T(2 * running_error::tiny<T>));
    const T spread = (numerator + lost_to_underflow) / (abs(y.value) - y.error);
    const T rounded = of(z, spread + running_error::of_product(z)).error;
    return {z, select(y.may_be_zero(), T(infinity<T>), select(x.is_exact_zero(), T(0), rounded))};
  }

  friend constexpr auto operator<(const Bounded& x, const Bounded& y) {
    return BoundedMaskOf<Mask<T>>{x.value < y.value, apart(x, y)};
  }
  friend constexpr auto operator<=(const Bounded& x, const Bounded& y) {
    return BoundedMaskOf<Mask<T>>{x.value <= y.value, apart(x, y)};
  }
  friend constexpr auto operator==(const Bounded& x, const Bounded& y) {
    return BoundedMaskOf<Mask<T>>{x.value == y.value, apart(x, y)};
  }

  /// How far the errors of the factors can move their product.
  [[nodiscard]] static constexpr T spread_of_product(const Bounded& x, const Bounded& y) {
    return abs(x.value) * y.error + abs(y.value) * x.error + x.error * y.error;
  }
  /// Whether the exact numbers compare as the values do.
  [[nodiscard]] static constexpr Mask<T> apart(const Bounded& x, const Bounded& y) {
    const Mask<T> are_exact = x.error == T(0) && y.error == T(0);
    return are_exact || abs(x.value - y.value) > running_error::up(running_error::up(x.error + y.error));
  }
};

}  // namespace rayproof

#include <rayproof/arithmetics/bounded_functions.hpp>  // IWYU pragma: export

#include <rayproof/rounding/as_before.hpp>
