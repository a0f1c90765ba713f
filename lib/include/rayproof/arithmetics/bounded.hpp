#pragma once
/// \file
/// Running error analysis: every number carries a bound on its own error, computed beside it.
///
/// Source: J. H. Wilkinson's a-posteriori analysis as presented by N. J. Higham, "Accuracy and Stability of
/// Numerical Algorithms", ch. 3.3, 2002; here with underflow, overflow and uncertain comparisons.

#include <concepts>
#include <rayproof/arithmetics/running_error.hpp>
#include <type_traits>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// A number of type `T`, plain, a double-double, or a pack of either, and a bound on its error, in doubles
/// where T is in double-doubles: |value - exact| <= error, where *exact* is what the formula gives for the
/// exact inputs in real numbers. The bound is infinite where nothing can be said: NaN, overflow, a divisor
/// that may be 0. Where a root's radicand may be negative, the bound holds if the exact one is not.
///
/// Rounds bit for bit as `T` does. Comparisons and `select` follow the values; where the exact numbers might
/// choose the other branch, the bound covers that branch too.
template <class T>
struct Bounded : Comparable<Bounded<T>> {
  using Plain = rayproof::Plain<T>;
  using Error = Leading<T>;

  T value{};
  Error error{};

  constexpr Bounded() = default;
  constexpr Bounded(const T& rounded, const Error& bound) : value(rounded), error(bound) {}
  /// An exact number, or the nearest `T` to one with the error of that.
  template <HeldByDouble U>
  // NOLINTNEXTLINE(google-explicit-constructor): kernels mix plain numbers in, as formulas do
  constexpr Bounded(U exact) : value(static_cast<Plain>(exact)), error(Plain(0)) {
    const auto rounded = static_cast<Plain>(exact);
    const auto back = static_cast<double>(rounded);
    const auto wide = static_cast<double>(exact);
    if (back != wide)
      error = Error(running_error::up(static_cast<Plain>(back < wide ? wide - back : back - wide)));
    error = select(value == value, error, Error(infinity<T>));  // not every number has a double-double
  }
  /// An exact number in several parts, or a pack of them.
  constexpr explicit Bounded(const T& exact) requires(!std::is_arithmetic_v<T>)
      : value(exact), error(select(exact == exact, Error(0), Error(infinity<T>))) {}
  /// The same number in all lanes of a pack.
  template <std::same_as<Plain> U>
  requires(!std::is_arithmetic_v<T>) constexpr explicit Bounded(const Bounded<U>& same)
      : value(T(same.value)), error(Error(same.error)) {}

  /// A rounded value and a bound, infinite where either is not finite.
  [[nodiscard]] static constexpr Bounded of(const T& value, const Error& bound) {
    const Mask<T> is_bounded =
        running_error::size(value) < Error(infinity<T>) && abs(bound) < Error(infinity<T>);
    return {value, select(is_bounded, running_error::up(bound), Error(infinity<T>))};
  }

  [[nodiscard]] constexpr Mask<T> is_exact_zero() const { return value == T(0) && error == Error(0); }
  [[nodiscard]] constexpr Mask<T> may_be_zero() const { return !(least_size() > error); }
  /// No more than |value|.
  [[nodiscard]] constexpr Error least_size() const {
    return Error(running_error::sure_part<T>) * running_error::size(value);
  }

  friend constexpr Bounded operator-(const Bounded& x) { return {-x.value, x.error}; }
  friend constexpr Bounded operator+(const Bounded& x, const Bounded& y) {
    const T z = x.value + y.value;
    const Error terms = running_error::size(x.value) + running_error::size(y.value);
    return of(z, x.error + y.error + running_error::of_sum(z, terms));
  }
  friend constexpr Bounded operator-(const Bounded& x, const Bounded& y) { return x + (-y); }
  friend constexpr Bounded operator*(const Bounded& x, const Bounded& y) {
    const T z = x.value * y.value;
    const Mask<T> is_exact = (x.is_exact_zero() || y.is_exact_zero()) && z == T(0);
    const Error rounded = of(z, spread_of_product(x, y) + running_error::of_product(z)).error;
    return {z, select(is_exact, Error(0), rounded)};
  }
  /// X/Y - x/y = ((X - x) - (x/y)(Y - y)) / Y.
  friend constexpr Bounded operator/(const Bounded& x, const Bounded& y) {
    using running_error::size, running_error::tiny;
    const T z = x.value / y.value;
    const Error numerator = x.error + (size(z) + Error(2 * tiny<T>)) * y.error;
    const Mask<T> are_exact = x.error == Error(0) && y.error == Error(0);
    const Error lost = select(are_exact, Error(running_error::lost_of_operand<T>), Error(2 * tiny<T>));
    const Error spread = (numerator + lost) / (y.least_size() - y.error);
    const Error rounded = of(z, spread + running_error::of_product(z)).error;
    return {z, select(y.may_be_zero(), Error(infinity<T>), select(x.is_exact_zero(), Error(0), rounded))};
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
  [[nodiscard]] static constexpr Error spread_of_product(const Bounded& x, const Bounded& y) {
    using running_error::size;
    return size(x.value) * y.error + size(y.value) * x.error + x.error * y.error;
  }
  /// Whether the exact numbers compare as the values do.
  [[nodiscard]] static constexpr Mask<T> apart(const Bounded& x, const Bounded& y) {
    const Mask<T> are_exact = x.error == Error(0) && y.error == Error(0);
    const Error together = x.error + y.error + running_error::doubt_of_distance(x.value, y.value);
    return are_exact ||
           running_error::distance(x.value, y.value) > running_error::up(running_error::up(together));
  }
};

}  // namespace rayproof

#include <rayproof/arithmetics/bounded_functions.hpp>  // IWYU pragma: export

#include <rayproof/rounding/as_before.hpp>
