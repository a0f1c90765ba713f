#pragma once
/// \file
/// The functions of arithmetic.hpp for recorded numbers; included by recorded.hpp.

#include <algorithm>
#include <rayproof/arithmetics/recorded.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

template <class T, class S>
[[nodiscard]] Recorded<T, S> select(BoundedMask mask, const Recorded<T, S>& yes, const Recorded<T, S>& no) {
  return (mask.value ? yes : no).with(select(mask, yes.bounded, no.bounded));
}

template <class T, class S>
[[nodiscard]] Recorded<T, S> sqrt(const Recorded<T, S>& x) {
  const S root = x.exact < 0 ? S(std::numeric_limits<S>::quiet_NaN()) : S(sqrt(x.exact));
  return {Operator::square_root, sqrt(x.bounded), root, x.id};
}

template <class T, class S>
[[nodiscard]] Recorded<T, S> abs(const Recorded<T, S>& x) {
  return {Operator::absolute, abs(x.bounded), S(abs(x.exact)), x.id};
}

template <class T, class S>
[[nodiscard]] Recorded<T, S> copysign(const Recorded<T, S>& x, const Recorded<T, S>& sign) {
  const S size = abs(x.exact);
  const S signed_size = std::signbit(sign.value()) ? S(-size) : size;
  return {Operator::copy_sign, copysign(x.bounded, sign.bounded), signed_size, x.id, sign.id};
}

template <class T, class S>
[[nodiscard]] Recorded<T, S> fma(const Recorded<T, S>& x, const Recorded<T, S>& y, const Recorded<T, S>& z) {
  const S sum = x.exact * y.exact + z.exact;
  return {Operator::fused_multiply_add, fma(x.bounded, y.bounded, z.bounded), sum, x.id, y.id, z.id};
}

template <class T, class S>
[[nodiscard]] Recorded<T, S> min(const Recorded<T, S>& x, const Recorded<T, S>& y) {
  return (y < x ? y : x).with(min(x.bounded, y.bounded));
}

template <class T, class S>
[[nodiscard]] Recorded<T, S> max(const Recorded<T, S>& x, const Recorded<T, S>& y) {
  return (x < y ? y : x).with(max(x.bounded, y.bounded));
}

// Steps and exponents are decisions, not measurements: the shadow follows the rounded value in them.

template <class T, class S>
[[nodiscard]] Recorded<T, S> exponent(const Recorded<T, S>& x) {
  const Bounded<T> e = exponent(x.bounded);
  return {Operator::exponent, e, S(e.value), x.id};
}

template <class T, class S>
[[nodiscard]] Recorded<T, S> floor(const Recorded<T, S>& x) {
  const Bounded<T> whole = floor(x.bounded);
  return {Operator::floor, whole, S(whole.value), x.id};
}

/// An infinite or NaN exponent leaves nothing to scale: the shadow then is what the rounded value is.
template <class T, class S>
[[nodiscard]] Recorded<T, S> scale_exponent(const Recorded<T, S>& x, const Recorded<T, S>& e) {
  const Bounded<T> rounded = scale_exponent(x.bounded, e.bounded);
  const bool scales = std::isfinite(e.value());
  const double power = std::clamp(static_cast<double>(e.value()), -1e5, 1e5);  // beyond all, and an int
  const S scaled = scales ? S(ldexp(x.exact, static_cast<int>(power))) : S(rounded.value);
  return {Operator::scale_exponent, rounded, scaled, x.id, e.id};
}

template <std::same_as<float> T, class S>
[[nodiscard]] Recorded<double, S> widen(const Recorded<T, S>& x) {
  return x.with(widen(x.bounded));
}
template <std::same_as<double> T, class S>
[[nodiscard]] Recorded<float, S> narrow(const Recorded<T, S>& x) {
  return x.with(narrow(x.bounded));
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
