#pragma once
/// \file
/// What bounded.hpp is made of: bounds on the rounding error of one operation, and comparisons that know
/// whether the exact numbers compare alike. A bound on the error of a `T` is a `Leading<T>`.

#include <concepts>
#include <limits>
#include <rayproof/arithmetic.hpp>

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

/// No less than what underflow takes. In double not the least number there is: processors are slow with such.
template <class T>
inline constexpr Plain<T> tiny = std::same_as<Plain<T>, float> ? std::numeric_limits<Plain<T>>::denorm_min()
                                                               : std::numeric_limits<Plain<T>>::min();

/// Whether a number is one word, or a pack of such: it is its own leading part.
template <class T>
inline constexpr bool is_word = std::same_as<T, Leading<T>>;
/// What underflow can take from an exact operand before it is divided, or its root is taken: nothing, unless
/// the arithmetic forms a remainder.
template <class T>
inline constexpr Plain<T> lost_of_operand = is_word<T> ? 0 : 2 * tiny<T>;
/// The part of its size that a number surely has.
template <class T>
inline constexpr Plain<T> sure_part = is_word<T> ? 1 : 1 - 4 * unit_roundoff<Plain<T>>;

/// The size of a number, to within a rounding of its bound.
template <class T>
[[nodiscard]] constexpr Leading<T> size(const T& x) {
  return abs(leading(x));
}

/// How far apart two numbers are, to within `doubt_of_distance` and a rounding of its bound; infinite where
/// one of them is, which the difference of two double-doubles need not be.
template <class T>
[[nodiscard]] constexpr Leading<T> distance(const T& x, const T& y) {
  const Leading<T> roughly = abs(leading(x) - leading(y));
  if constexpr (is_word<T>) {
    return roughly;
  } else {
    return select(roughly < Leading<T>(infinity<T>), size(x - y), roughly);
  }
}
template <class T>
[[nodiscard]] constexpr Leading<T> doubt_of_distance(const T& x, const T& y) {
  using E = Leading<T>;
  if constexpr (is_word<T>) {
    return E(0);
  } else {
    const E sizes = size(x) + size(y);
    return select(sizes < E(infinity<T>), E(unit_roundoff<T>) * sizes, E(0));
  }
}

/// Outweighs the roundings made in computing a bound itself: a sum of at most eight positive products.
template <class E>
[[nodiscard]] constexpr E up(const E& bound) {
  return bound * E(1 + 32 * unit_roundoff<E>);
}

/// Bounds the rounding error of a sum whose rounded value is z, and whose terms have this size together; sums
/// below 2·min are exact.
template <class T>
[[nodiscard]] Leading<T> of_sum(const T& z, const Leading<T>& terms) {
  using E = Leading<T>;
  return select(size(z) < E(2 * std::numeric_limits<Plain<T>>::min()), E(0),
                E(unit_roundoff<T>) * (is_word<T> ? size(z) : terms) + E(tiny<T>));
}

/// Bounds the rounding error of a product or quotient z, and what underflow took from the terms of its bound.
template <class T>
[[nodiscard]] Leading<T> of_product(const T& z) {
  using E = Leading<T>;
  return E(unit_roundoff<T>) * size(z) + E(4 * tiny<T>);
}

}  // namespace running_error

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
