#pragma once
/// \file
/// Expansions: sums, differences and products of floating-point numbers with no rounding at all.
///
/// An expansion is an unevaluated sum of floating-point terms that do not overlap, smallest first, none of
/// them 0. `+ - *` between expansions are exact as long as no term over- or underflows, so a formula without
/// division or root has its exact value, and the sign of that value is the sign of the last term. Source: J.
/// R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997.

#include <array>
#include <cstddef>
#include <rayproof/arithmetic.hpp>
#include <rayproof/arithmetics/error_free.hpp>
#include <rayproof/vec3.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// Packs the digits of an expansion into as few terms as hold them, in place, and returns how many those are
/// (Shewchuk's COMPRESS). Sums leave many short terms, and a product takes time for each pair of them.
template <std::floating_point T>
[[nodiscard]] constexpr std::size_t compress(T* terms, std::size_t count) {
  if (count < 2) return count;
  std::size_t bottom = count - 1;
  T sum = terms[bottom];
  if (!(abs(sum) < infinity<T>)) {  // an overflow has no digits to keep, and would breed terms without end
    terms[0] = not_a_number<T>;
    return 1;
  }
  for (std::size_t i = count - 1; i-- > 0;) {
    const auto [rounded, rest] = two_sum(sum, terms[i]);
    sum = rounded;
    if (rest == 0) continue;
    terms[bottom--] = rounded;
    sum = rest;
  }
  terms[bottom] = sum;
  std::size_t kept = 0;
  for (std::size_t i = bottom + 1; i < count; ++i) {
    const auto [rounded, rest] = two_sum(terms[i], sum);
    sum = rounded;
    if (rest != 0) terms[kept++] = rest;
  }
  terms[kept] = sum;
  return kept + 1;
}

/// Adds one number to an expansion exactly, in place, and returns how many terms there are then; there must
/// be room for one more (Shewchuk's GROW-EXPANSION with zero elimination).
template <std::floating_point T>
[[nodiscard]] constexpr std::size_t grow(T* terms, std::size_t count, T value) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto [rounded, rest] = two_sum(terms[i], value);
    if (rest != 0) terms[kept++] = rest;
    value = rounded;
  }
  if (value != 0) terms[kept++] = value;
  return kept;
}

/// Adds x·y to a sum exactly.
template <class Sum, std::floating_point T>
constexpr void add_product(Sum& sum, T x, T y) {
  const auto [rounded, rest] = two_product(x, y);
  if (rest != 0) sum.add(rest);
  sum.add(rounded);
}

/// Few terms are not worth packing.
inline constexpr std::size_t few_terms = 4;

/// The sum of `terms[0 .. count)`; `Capacity` is the most terms the operations that led here can leave.
template <std::floating_point T, std::size_t Capacity>
struct Expansion {
  std::array<T, Capacity> terms;
  std::size_t count = 0;

  constexpr Expansion() {}  // NOLINT(modernize-use-equals-default): `terms` beyond `count` stay uninitialised
  constexpr explicit Expansion(T value) { push(value); }

  /// Appends a term larger than all others; 0 leaves no trace.
  constexpr void push(T term) {
    if (term != 0) terms[count++] = term;
  }

  /// Packs the digits into as few terms as hold them, where there are more than a few.
  constexpr void tidy() {
    if (count > few_terms) count = compress(terms.data(), count);
  }

  /// Adds one number exactly.
  constexpr void add(T value) { count = grow(terms.data(), count, value); }
};

/// A plain number as an expansion.
template <std::floating_point T>
[[nodiscard]] constexpr Expansion<T, 1> exact(T x) {
  return Expansion<T, 1>(x);
}

/// A vector of plain numbers as a vector of expansions over `T`, which holds them exactly.
template <std::floating_point T, class V>
[[nodiscard]] constexpr Vec3<Expansion<T, 1>> exact_vector(const V& v) {
  return {exact(T(v.x)), exact(T(v.y)), exact(T(v.z))};
}

template <class T, std::size_t N>
[[nodiscard]] constexpr Expansion<T, N> operator-(Expansion<T, N> x) {
  for (std::size_t i = 0; i < x.count; ++i) x.terms[i] = -x.terms[i];
  return x;
}

template <class T, std::size_t N, std::size_t M>
[[nodiscard]] constexpr Expansion<T, N + M> operator+(const Expansion<T, N>& x, const Expansion<T, M>& y) {
  Expansion<T, N + M> sum;
  for (std::size_t i = 0; i < x.count; ++i) sum.push(x.terms[i]);
  for (std::size_t i = 0; i < y.count; ++i) sum.add(y.terms[i]);
  sum.tidy();
  return sum;
}

template <class T, std::size_t N, std::size_t M>
[[nodiscard]] constexpr Expansion<T, N + M> operator-(const Expansion<T, N>& x, const Expansion<T, M>& y) {
  return x + (-y);
}

template <class T, std::size_t N, std::size_t M>
[[nodiscard]] constexpr Expansion<T, 2 * N * M> operator*(const Expansion<T, N>& x,
                                                          const Expansion<T, M>& y) {
  Expansion<T, 2 * N * M> product;
  for (std::size_t i = 0; i < x.count; ++i) {
    for (std::size_t j = 0; j < y.count; ++j) add_product(product, x.terms[i], y.terms[j]);
  }
  product.tidy();
  return product;
}

/// The value to within one ulp, with the exact sign; 0 only where the value is 0.
template <class T, std::size_t N>
[[nodiscard]] constexpr T estimate(const Expansion<T, N>& x) {
  T sum = 0;
  for (std::size_t i = 0; i < x.count; ++i) sum += x.terms[i];
  return sum;
}

/// The sign of the exact value: -1, 0 or 1.
template <class T, std::size_t N>
[[nodiscard]] constexpr int sign(const Expansion<T, N>& x) {
  if (x.count == 0) return 0;
  return x.terms[x.count - 1] > 0 ? 1 : -1;
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
