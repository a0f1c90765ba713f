#pragma once
/// \file
/// Exact sums of any length: the expansions of expansion.hpp without a capacity, for formulas that run over
/// as many terms as a polygon has sides.

#include <algorithm>
#include <cstddef>
#include <rayproof/arithmetics/expansion.hpp>
#include <vector>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// The sum of `terms`, which do not overlap, smallest first, none of them 0. `+ - *` are exact as long as no
/// term over- or underflows.
template <std::floating_point T>
class GrowingExpansion {
 public:
  GrowingExpansion() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): plain numbers are exact, and formulas mix them in
  GrowingExpansion(T value) { add(value); }

  [[nodiscard]] const std::vector<T>& terms() const { return terms_; }

  /// Adds one number exactly.
  void add(T value) {
    const std::size_t count = terms_.size();
    terms_.resize(count + 1);
    terms_.resize(grow(terms_.data(), count, value));
  }

  /// Packs the digits into as few terms as hold them, where there are more than a few.
  void tidy() {
    if (terms_.size() > few_terms) terms_.resize(compress(terms_.data(), terms_.size()));
  }

  friend GrowingExpansion operator-(GrowingExpansion x) {
    for (T& term : x.terms_) term = -term;
    return x;
  }
  friend GrowingExpansion operator+(GrowingExpansion x, const GrowingExpansion& y) {
    for (const T term : y.terms_) x.add(term);
    x.tidy();
    return x;
  }
  friend GrowingExpansion operator-(GrowingExpansion x, const GrowingExpansion& y) {
    for (const T term : y.terms_) x.add(-term);
    x.tidy();
    return x;
  }
  friend GrowingExpansion operator*(const GrowingExpansion& x, const GrowingExpansion& y) {
    GrowingExpansion product;
    for (const T x_term : x.terms_) {
      for (const T y_term : y.terms_) add_product(product, x_term, y_term);
      product.tidy();
    }
    return product;
  }

 private:
  std::vector<T> terms_;
};

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
  std::vector<T> packed = x.terms();
  packed.resize(compress(packed.data(), packed.size()));
  Expansion<T, Capacity> result;
  for (std::size_t i = packed.size() - std::min(packed.size(), Capacity); i < packed.size(); ++i)
    result.push(packed[i]);
  return result;
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
