#pragma once
/// \file
/// Exact sums of any length: the expansions of expansion.hpp without a capacity of the formula's own,
/// for those that run over as many terms as a polygon has sides, or are of a high degree.

#include <algorithm>
#include <array>
#include <cstddef>
#include <rayproof/arithmetics/expansion.hpp>
#include <span>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// The sum of `terms`, which do not overlap, smallest first, none of them 0. `+ - *` are exact as long as no
/// term over- or underflows.
///
/// The terms are on the stack. Packed, each is no more than half an ulp of the next: 42 doubles then span all
/// exponents there are, and twice as many come in one by one before they are packed again.
template <std::floating_point T>
class GrowingExpansion {
 public:
  static constexpr std::size_t capacity = 128;

  GrowingExpansion() {}  // NOLINT(modernize-use-equals-default): `terms_` beyond `count_` stay uninitialised
  // NOLINTNEXTLINE(google-explicit-constructor): plain numbers are exact, and formulas mix them in
  GrowingExpansion(T value) { add(value); }
  template <std::size_t N>
  // NOLINTNEXTLINE(google-explicit-constructor): the same number
  GrowingExpansion(const Expansion<T, N>& x) {
    for (std::size_t i = 0; i < x.count; ++i) add(x.terms[i]);
  }
  GrowingExpansion(const GrowingExpansion& other) { *this = other; }
  GrowingExpansion& operator=(const GrowingExpansion& other) {
    std::copy_n(other.terms_.begin(), other.count_, terms_.begin());
    count_ = other.count_;
    return *this;
  }
  ~GrowingExpansion() = default;

  [[nodiscard]] std::span<const T> terms() const { return {terms_.data(), count_}; }

  /// Adds one number exactly.
  void add(T value) {
    if (count_ == capacity) tidy();
    count_ = grow(terms_.data(), count_, value);
  }

  /// Packs the digits into as few terms as hold them, where there are more than a few.
  void tidy() {
    if (count_ > few_terms) count_ = compress(terms_.data(), count_);
  }

  friend GrowingExpansion operator-(GrowingExpansion x) {
    for (std::size_t i = 0; i < x.count_; ++i) x.terms_[i] = -x.terms_[i];
    return x;
  }
  friend GrowingExpansion operator+(GrowingExpansion x, const GrowingExpansion& y) {
    for (const T term : y.terms()) x.add(term);
    x.tidy();
    return x;
  }
  friend GrowingExpansion operator-(GrowingExpansion x, const GrowingExpansion& y) {
    for (const T term : y.terms()) x.add(-term);
    x.tidy();
    return x;
  }
  friend GrowingExpansion operator*(const GrowingExpansion& x, const GrowingExpansion& y) {
    GrowingExpansion product;
    for (const T x_term : x.terms()) {
      for (const T y_term : y.terms()) add_product(product, x_term, y_term);
      product.tidy();
    }
    return product;
  }

 private:
  std::array<T, capacity> terms_;
  std::size_t count_ = 0;
};

/// The value to within one ulp, with the exact sign; 0 only where the value is 0.
template <class T>
[[nodiscard]] T estimate(GrowingExpansion<T> x) {
  x.tidy();
  T sum = 0;
  for (const T term : x.terms()) sum += term;
  return sum;
}

/// The sign of the exact value: -1, 0 or 1.
template <class T>
[[nodiscard]] int sign(const GrowingExpansion<T>& x) {
  if (x.terms().empty()) return 0;
  return x.terms().back() > 0 ? 1 : -1;
}

/// The magnitude, exactly.
template <class T>
[[nodiscard]] GrowingExpansion<T> abs(const GrowingExpansion<T>& x) {
  return sign(x) < 0 ? -x : x;
}

template <class T>
[[nodiscard]] bool operator>(const GrowingExpansion<T>& x, const GrowingExpansion<T>& y) {
  return sign(x - y) > 0;
}

/// The exact value in an expansion of fixed capacity, which may be too small: each term but the last then
/// holds all digits that fit, and what is lost is below the last of them. A value whose digits lie within
/// 2^±500 has at most 20 terms.
template <std::size_t Capacity, class T>
[[nodiscard]] Expansion<T, Capacity> compressed(const GrowingExpansion<T>& x) {
  GrowingExpansion<T> packed = x;
  packed.tidy();
  const std::span<const T> terms = packed.terms();
  Expansion<T, Capacity> result;
  for (const T term : terms.last(std::min(terms.size(), Capacity))) result.push(term);
  return result;
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
