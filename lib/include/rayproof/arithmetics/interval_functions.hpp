#pragma once
/// \file
/// The functions of arithmetic.hpp for intervals, and what sets have besides; included by interval.hpp.

#include <rayproof/arithmetics/interval.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// The smallest interval around both; an empty one adds nothing.
template <class T>
[[nodiscard]] constexpr Interval<T> hull(const Interval<T>& x, const Interval<T>& y) {
  if (x.is_empty()) return y;
  if (y.is_empty()) return x;
  return Interval<T>::between(min(x.lo, y.lo), max(x.hi, y.hi));
}

/// What both have in common, perhaps nothing.
template <class T>
[[nodiscard]] constexpr Interval<T> intersection(const Interval<T>& x, const Interval<T>& y) {
  const T lo = max(x.lo, y.lo);
  const T hi = min(x.hi, y.hi);
  if (x.is_empty() || y.is_empty() || !(lo <= hi)) return Interval<T>::empty();
  return Interval<T>::between(lo, hi);
}

/// The chosen interval; both, where the choice is uncertain.
template <class T>
[[nodiscard]] constexpr Interval<T> select(IntervalMask mask, const Interval<T>& yes, const Interval<T>& no) {
  if (mask.holds_for_certain()) return yes;
  return mask.may_hold ? hull(yes, no) : no;
}

/// The roots of what is not negative in it; empty where nothing is.
template <class T>
[[nodiscard]] Interval<T> sqrt(const Interval<T>& x) {
  if (!(x.hi >= 0)) return Interval<T>::empty();
  return Interval<T>::between(outward::root_down(max(x.lo, T(0))), outward::root_up(x.hi));
}

template <class T>
[[nodiscard]] constexpr Interval<T> abs(const Interval<T>& x) {
  if (x.lo >= 0 || x.is_empty()) return x;
  return x.hi <= 0 ? -x : Interval<T>::between(0, max(-x.lo, x.hi));
}

/// {x² | x in X}: tighter than X·X where X has both signs, since there both factors are the same number.
template <class T>
[[nodiscard]] Interval<T> square(const Interval<T>& x) {
  if (x.is_empty()) return x;
  const Interval<T> size = abs(x);
  return Interval<T>::between(outward::product_down(size.lo, size.lo), outward::product_up(size.hi, size.hi));
}

/// An interval that touches 0 has either sign: it may stand for -0, or for a number that underflowed.
template <class T>
[[nodiscard]] constexpr Interval<T> copysign(const Interval<T>& x, const Interval<T>& sign) {
  if (sign.is_empty()) return sign;
  const Interval<T> size = abs(x);
  return sign.lo > 0 ? size : sign.hi < 0 ? -size : hull(size, -size);
}

template <class T>
[[nodiscard]] Interval<T> fma(const Interval<T>& x, const Interval<T>& y, const Interval<T>& z) {
  return x * y + z;
}

template <class T>
[[nodiscard]] constexpr Interval<T> min(const Interval<T>& x, const Interval<T>& y) {
  if (x.is_empty() || y.is_empty()) return Interval<T>::empty();
  return Interval<T>::between(min(x.lo, y.lo), min(x.hi, y.hi));
}
template <class T>
[[nodiscard]] constexpr Interval<T> max(const Interval<T>& x, const Interval<T>& y) {
  return -min(-x, -y);
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
