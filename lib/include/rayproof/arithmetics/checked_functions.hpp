#pragma once
/// \file
/// The functions of arithmetic.hpp for checked numbers; included by checked.hpp.

#include <rayproof/arithmetics/checked.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

template <class T>
[[nodiscard]] constexpr Checked<T> select(CheckedMask mask, const Checked<T>& yes, const Checked<T>& no) {
  const Checked<T>& chosen = mask.value ? yes : no;
  return {chosen.value, mask.is_exact && chosen.is_exact};
}

template <class T>
[[nodiscard]] Checked<T> sqrt(const Checked<T>& x) {
  const T z = std::sqrt(x.value);
  return {z, x.is_exact && exactness::of_root(x.value, z)};
}

template <class T>
[[nodiscard]] Checked<T> fma(const Checked<T>& x, const Checked<T>& y, const Checked<T>& w) {
  const T z = std::fma(x.value, y.value, w.value);
  const bool are_exact = x.is_exact && y.is_exact && w.is_exact;
  return {z, are_exact && exactness::of_product_and_sum(x.value, y.value, w.value, z)};
}

template <class T>
[[nodiscard]] Checked<T> abs(const Checked<T>& x) {
  return {std::abs(x.value), x.is_exact};
}

template <class T>
[[nodiscard]] Checked<T> copysign(const Checked<T>& x, const Checked<T>& sign) {
  return {std::copysign(x.value, sign.value), x.is_exact && sign.is_exact};
}

template <class T>
[[nodiscard]] constexpr Checked<T> min(const Checked<T>& x, const Checked<T>& y) {
  return select(y < x, y, x);
}
template <class T>
[[nodiscard]] constexpr Checked<T> max(const Checked<T>& x, const Checked<T>& y) {
  return select(x < y, y, x);
}

template <class T>
[[nodiscard]] Checked<T> exponent(const Checked<T>& x) {
  return {std::logb(x.value), x.is_exact};
}
template <class T>
[[nodiscard]] Checked<T> floor(const Checked<T>& x) {
  return {std::floor(x.value), x.is_exact};
}
/// Exact where scaling back gives the number again.
template <class T>
[[nodiscard]] Checked<T> scale_exponent(const Checked<T>& x, const Checked<T>& e) {
  const T z = rayproof::scale_exponent(x.value, e.value);
  return {z, x.is_exact && e.is_exact && rayproof::scale_exponent(z, -e.value) == x.value};
}

template <std::same_as<float> T>
[[nodiscard]] constexpr Checked<double> widen(const Checked<T>& x) {
  return {x.value, x.is_exact};
}
template <std::same_as<double> T>
[[nodiscard]] constexpr Checked<float> narrow(const Checked<T>& x) {
  const auto value = static_cast<float>(x.value);
  return {value, x.is_exact && (value != value || double{value} == x.value)};
}

/// Whether the value is neither infinite nor NaN. One that is, since an overflow or what came of it was
/// rounded, decides as a comparison of rounded numbers does.
template <class T>
[[nodiscard]] bool is_finite(const Checked<T>& x) {
  const bool is_number = std::isfinite(x.value);
  if (!is_number && !x.is_exact) RoundedDecision::note();
  return is_number;
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
