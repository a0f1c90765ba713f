#pragma once
/// \file
/// The functions of arithmetic.hpp for numbers with a running error bound; included by bounded.hpp.

#include <rayproof/arithmetics/bounded.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// The chosen number; where the choice is uncertain, its bound reaches over the other one too.
template <class T>
[[nodiscard]] constexpr Bounded<T> select(const BoundedMaskOf<Mask<T>>& mask, const Bounded<T>& yes,
                                          const Bounded<T>& no) {
  const T chosen = select(mask.value, yes.value, no.value);
  const Leading<T> apart =
      running_error::distance(yes.value, no.value) + running_error::doubt_of_distance(yes.value, no.value);
  const Bounded<T> either = Bounded<T>::of(chosen, apart + max(yes.error, no.error));
  return {chosen, select(mask.certain, select(mask.value, yes.error, no.error), either.error)};
}

/// |√X - √x| is at most |X - x| / (√x + √(x - error)), and near 0, where that explodes, at most √|X - x|.
template <class T>
[[nodiscard]] Bounded<T> sqrt(const Bounded<T>& x) {
  using E = Leading<T>;
  const T root = sqrt(x.value);
  const E z = leading(root), error = x.error + E(running_error::lost_of_operand<T>);
  const E above_zero = E(running_error::sure_part<T>) * leading(x.value) - running_error::up(error);
  const E least = max(E(0), above_zero) * E(1 - 8 * unit_roundoff<E>);
  const E smooth = error / (z + sqrt(least)) + E(running_error::tiny<T>);
  const E near_zero = sqrt(error);
  const E spread = select(z > E(0), min(smooth, near_zero), near_zero);
  return Bounded<T>::of(root, select(error == E(0), E(0), spread) + E(unit_roundoff<T>) * abs(z));
}

template <class T>
[[nodiscard]] Bounded<T> abs(const Bounded<T>& x) {
  return {abs(x.value), x.error};
}

/// Where the sign is uncertain, the bound reaches over both signs.
template <class T>
[[nodiscard]] Bounded<T> copysign(const Bounded<T>& x, const Bounded<T>& sign) {
  using E = Leading<T>;
  const T z = copysign(x.value, sign.value);
  const Mask<T> is_sure = sign.error == E(0) || !sign.may_be_zero();
  const Bounded<T> either = Bounded<T>::of(z, E(2) * running_error::size(x.value) + x.error);
  return {z, select(is_sure, x.error, either.error)};
}

template <class T>
[[nodiscard]] Bounded<T> fma(const Bounded<T>& x, const Bounded<T>& y, const Bounded<T>& z) {
  const T w = fma(x.value, y.value, z.value);
  return Bounded<T>::of(w, Bounded<T>::spread_of_product(x, y) + z.error + running_error::of_product(w));
}

/// Continuous, hence off by no more than the worse of its operands whichever the exact one would be.
template <class T>
[[nodiscard]] constexpr Bounded<T> min(const Bounded<T>& x, const Bounded<T>& y) {
  return {min(x.value, y.value), max(x.error, y.error)};
}
template <class T>
[[nodiscard]] constexpr Bounded<T> max(const Bounded<T>& x, const Bounded<T>& y) {
  return {max(x.value, y.value), max(x.error, y.error)};
}

/// Runs a step function at both ends of what the exact number may be.
template <std::floating_point T, class Step>
[[nodiscard]] Bounded<T> step_function(const Bounded<T>& x, T lowest, T highest, Step&& value_at) {
  const T z = value_at(x.value);
  if (x.error == 0) return Bounded<T>(z);
  return Bounded<T>::of(z, std::max(value_at(highest) - z, z - value_at(lowest)));
}
template <std::floating_point T>
[[nodiscard]] Bounded<T> exponent(const Bounded<T>& x) {
  const T size = std::abs(x.value);
  const T reach = running_error::up(x.error);
  const T lowest = std::max(T(0), (size - reach) * (1 - 2 * unit_roundoff<T>));
  return step_function(x, lowest, running_error::up(size + reach), [](T at) { return std::logb(at); });
}
template <std::floating_point T>
[[nodiscard]] Bounded<T> floor(const Bounded<T>& x) {
  const T reach = running_error::up(x.error + running_error::of_product(x.value));
  return step_function(x, x.value - reach, x.value + reach, [](T at) { return std::floor(at); });
}
/// Nothing can be said where the exponent itself is uncertain.
template <std::floating_point T>
[[nodiscard]] Bounded<T> scale_exponent(const Bounded<T>& x, const Bounded<T>& e) {
  const T z = rayproof::scale_exponent(x.value, e.value);
  if (e.error != 0) return Bounded<T>::of(z, infinity<T>);
  const bool inexact = std::abs(z) < std::numeric_limits<T>::min() && x.value != 0;
  const T spread = rayproof::scale_exponent(x.error, e.value);
  return Bounded<T>::of(z, spread + (inexact || x.error != 0 ? 2 * running_error::tiny<T> : T(0)));
}

template <std::same_as<float> T>
[[nodiscard]] Bounded<double> widen(const Bounded<T>& x) {
  return {x.value, x.error};
}
template <std::same_as<double> T>
[[nodiscard]] Bounded<float> narrow(const Bounded<T>& x) {
  const auto value = static_cast<float>(x.value);
  const double error = x.error + std::abs(x.value - value);
  if (error == 0) return Bounded<float>::of(value, 0);
  // Rounded to float the bound may shrink, by less than the factor and the term make up for.
  const auto bound = static_cast<float>(error * (1 + 0x1p-22)) + running_error::tiny<float>;
  return Bounded<float>::of(value, bound);
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
