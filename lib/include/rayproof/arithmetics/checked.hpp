#pragma once
/// \file
/// The arithmetic that knows whether anything was rounded: every number carries a flag beside its value.
///
/// The flag belongs to the number and not to the whole run: what a `select` discards takes nothing from the
/// answer, and so most of the cases that lie on a boundary are still judged. The hardware's own flag would
/// not do: a compiler may move an operation across the place where the flag is read, or compute its result
/// beforehand.

#include <cmath>
#include <concepts>
#include <limits>
#include <rayproof/arithmetics/error_free.hpp>
#include <type_traits>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// Whether an `if` has followed a comparison of rounded numbers in this scope, on this thread. A scope inside
/// another leaves the outer one alone.
class RoundedDecision {
 public:
  RoundedDecision() { was_made_ = false; }
  ~RoundedDecision() { was_made_ = outer_; }
  RoundedDecision(const RoundedDecision&) = delete;
  RoundedDecision& operator=(const RoundedDecision&) = delete;

  [[nodiscard]] bool was_made() const { return was_made_; }
  static void note() { was_made_ = true; }

 private:
  static inline thread_local bool was_made_ = false;
  bool outer_ = was_made_;
};

/// A comparison's outcome, and whether the numbers compared were exact. Where one that was not decides an
/// `if`, the RoundedDecision of the scope notes it.
struct CheckedMask {
  bool value = false;
  bool is_exact = true;
  // NOLINTNEXTLINE(google-explicit-constructor): a plain outcome is an exact one
  constexpr CheckedMask(bool outcome, bool exactly = true) : value(outcome), is_exact(exactly) {}
  // NOLINTNEXTLINE(google-explicit-constructor): so that masks stand where the kernels have a bool
  constexpr operator bool() const {
    if (!is_exact) RoundedDecision::note();
    return value;
  }

  friend constexpr CheckedMask operator!(CheckedMask m) { return {!m.value, m.is_exact}; }
  friend constexpr CheckedMask operator&&(CheckedMask a, CheckedMask b) {
    return {a.value && b.value,
            (a.is_exact && b.is_exact) || (a.is_exact && !a.value) || (b.is_exact && !b.value)};
  }
  friend constexpr CheckedMask operator||(CheckedMask a, CheckedMask b) { return !(!a && !b); }
  // Beside a plain outcome the built-in operators would do as well: these are the better match.
  template <std::same_as<bool> Plain>
  friend constexpr CheckedMask operator&&(CheckedMask a, Plain b) {
    return a && CheckedMask(b);
  }
  template <std::same_as<bool> Plain>
  friend constexpr CheckedMask operator&&(Plain a, CheckedMask b) {
    return CheckedMask(a) && b;
  }
  template <std::same_as<bool> Plain>
  friend constexpr CheckedMask operator||(CheckedMask a, Plain b) {
    return a || CheckedMask(b);
  }
  template <std::same_as<bool> Plain>
  friend constexpr CheckedMask operator||(Plain a, CheckedMask b) {
    return CheckedMask(a) || b;
  }
};

/// Whether z, the result of an operation on plain numbers, is not rounded.
///
/// What IEEE 754 calls an invalid operation or a division by zero rounds nothing: NaN and infinity are its
/// exact results, and a kernel that lets them decide has them from its formula. An overflow is rounded, and
/// so counts a product or quotient so small that its rest might underflow.
namespace exactness {

template <class T>
inline constexpr T smallest_judged = std::numeric_limits<T>::min() /
                                     (std::numeric_limits<T>::epsilon() * std::numeric_limits<T>::epsilon());

template <std::floating_point... T>
[[nodiscard]] bool are_finite(T... operands) {
  return (std::isfinite(operands) && ...);
}

template <std::floating_point T>
[[nodiscard]] bool of_sum(T x, T y, T z) {
  return !are_finite(x, y) || (std::isfinite(z) && two_sum(x, y).rest == 0);
}
template <std::floating_point T>
[[nodiscard]] bool of_product(T x, T y, T z) {
  if (!are_finite(x, y) || x == 0 || y == 0) return true;
  return std::abs(z) >= smallest_judged<T> && std::fma(x, y, -z) == 0;
}
template <std::floating_point T>
[[nodiscard]] bool of_quotient(T x, T y, T z) {
  if (!are_finite(x, y) || x == 0 || y == 0) return true;
  return std::abs(x) >= smallest_judged<T> && std::fma(z, y, -x) == 0;
}
template <std::floating_point T>
[[nodiscard]] bool of_root(T x, T z) {
  if (!(x > 0) || !std::isfinite(x)) return true;
  return x >= smallest_judged<T> && std::fma(z, z, -x) == 0;
}
/// z = w + xy.
template <std::floating_point T>
[[nodiscard]] bool of_product_and_sum(T x, T y, T w, T z) {
  if (!are_finite(x, y, w)) return true;
  const auto [product, rest] = two_product(x, y);
  if (x != 0 && y != 0 && !(std::abs(product) >= smallest_judged<T>)) return false;
  const auto sum = two_sum(product, w);
  const auto rests = two_sum(sum.rest, rest);
  const auto total = two_sum(sum.rounded, rests.rounded);
  return total.rounded == z && total.rest == -rests.rest;
}

}  // namespace exactness

/// A number of type `T`, and whether it is exact: no step on the way to it was rounded, and no comparison of
/// rounded numbers has chosen it.
///
/// Rounds bit for bit as `T` does. A result counts as rounded where an operand does.
template <std::floating_point T>
struct Checked : Comparable<Checked<T>> {
  using Plain = T;
  /// Kernels may branch on comparisons: CheckedMask keeps the account.
  static constexpr bool may_branch = true;

  T value{};
  bool is_exact = true;

  constexpr Checked() = default;
  constexpr Checked(T rounded, bool exactly) : value(rounded), is_exact(exactly) {}
  /// An exact number, or the nearest `T` to one.
  template <HeldByDouble U>
  // NOLINTNEXTLINE(google-explicit-constructor): kernels mix plain numbers in, as formulas do
  constexpr Checked(U given)
      : value(static_cast<T>(given)),
        is_exact(value != value || static_cast<double>(value) == static_cast<double>(given)) {}

  friend constexpr Checked operator-(const Checked& x) { return {-x.value, x.is_exact}; }
  friend constexpr Checked operator+(const Checked& x, const Checked& y) {
    const T z = x.value + y.value;
    return {z, x.is_exact && y.is_exact && exactness::of_sum(x.value, y.value, z)};
  }
  friend constexpr Checked operator-(const Checked& x, const Checked& y) { return x + (-y); }
  friend constexpr Checked operator*(const Checked& x, const Checked& y) {
    const T z = x.value * y.value;
    return {z, x.is_exact && y.is_exact && exactness::of_product(x.value, y.value, z)};
  }
  friend constexpr Checked operator/(const Checked& x, const Checked& y) {
    const T z = x.value / y.value;
    return {z, x.is_exact && y.is_exact && exactness::of_quotient(x.value, y.value, z)};
  }

  friend constexpr CheckedMask operator<(const Checked& x, const Checked& y) {
    return {x.value < y.value, x.is_exact && y.is_exact};
  }
  friend constexpr CheckedMask operator<=(const Checked& x, const Checked& y) {
    return {x.value <= y.value, x.is_exact && y.is_exact};
  }
  friend constexpr CheckedMask operator==(const Checked& x, const Checked& y) {
    return {x.value == y.value, x.is_exact && y.is_exact};
  }
};

}  // namespace rayproof

#include <rayproof/arithmetics/checked_functions.hpp>  // IWYU pragma: export

#include <rayproof/rounding/as_before.hpp>
