#pragma once
/// \file
/// A number that is nearly a zero of a function, moved onto it by one step of Newton's method and rounded.
///
/// The function is computed with more digits at a number as short as the answer. Its value is small there, so
/// that the step, which is found without more digits, ends with nearly twice as many digits as it began with:
/// neither a quotient nor a root is ever computed with more.

#include <rayproof/formulas/rounding_test.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// No bound on an error is smaller: all that underflows is less, and neither its product with another such
/// nor its quotient by the inverse of one underflows.
template <class N>
inline constexpr Plain<N> least_error = std::same_as<Plain<N>, float> ? Plain<N>(0x1p-60)
                                                                      : Plain<N>(0x1p-400);

/// The same of lengths: the product of three and u is more than what underflow takes from one that is as
/// long.
template <class N>
inline constexpr Plain<N> least_length = std::same_as<Plain<N>, float> ? Plain<N>(0x1p-36)
                                                                       : Plain<N>(0x1p-250);

/// A number with more digits: one of any size, since the bounds below mind what under- and overflows.
template <class W, class N>
[[nodiscard]] constexpr W with_more_digits(const N& x) {
  if constexpr (requires { W::of_any_size(x); }) {
    return W::of_any_size(x);
  } else {
    return W(x);
  }
}

/// Each component without the digits beyond N's.
template <class N, class V>
[[nodiscard]] constexpr vec3<N> narrowed_vector(const V& v) {
  return {narrow(v.x), narrow(v.y), narrow(v.z)};
}

/// Where a correction starts: a t, and which of a solid's faces it is of: the first, second or third pair by
/// 1, 2 or 3, negative for the second of the pair. Infinity is a sure miss, NaN leaves all in doubt.
template <class N>
struct CorrectionStart {
  N t, face;
};

/// A function near t: its value and its slope there.
template <class N>
struct Linear {
  N value, slope;
};

/// A zero that was found from t: `answer` is the exact one rounded once where it is sure, and the exact one
/// lies within `doubt` of t - step.
template <class N>
struct Corrected {
  N answer;
  Mask<N> is_sure;
  N t, step, doubt;
};

/// The zero x of a function near t, rounded once: t less `value` over `slope`, the function's at t. It is
/// sure where every number that x may be rounds to one; ±0 is +0.
///
/// Let f(t) = m·(t - x), so that m is the mean slope on the way. `error` is a bound on |value - f(t)|, at
/// least `least_error`, and may leave out u·|value| for the rounding to N, u its unit roundoff.
/// `slope_error(s)` is a bound on |m - slope| where |t - x| <= (1 + 2^-9)·s, and may leave out 2u·|slope|.
/// Both are to be a fifth larger than what is known of them, for the roundings of what is computed with them
/// here.
///
/// With e and q these bounds, q less than |slope|/2^10, |m| is nearly |slope|, and the step, value
/// over slope, is off by less than (e + |step|·(q + 3u·|slope|))·(1 + 2^-9) / |slope| and its own rounding.
template <class N, class SlopeError>
[[nodiscard]] constexpr Corrected<N> newton_step(const N& t, const N& value, const N& error, const N& slope,
                                                 const SlopeError& slope_error) {
  const N size = abs(slope);
  const N per_size = reciprocal_bound(min(size, N(1 / least_error<N>)));
  const N step = value / slope;
  const N longest = abs(step) + error * per_size;
  const N doubt_of_slope = N(8 * unit_roundoff<N>) * size + slope_error(longest);
  const N doubt = (error + longest * doubt_of_slope) * per_size;
  const N low = t - (step + doubt), high = t - (step - doubt);
  return {low, low == high && N(0x1p10) * doubt_of_slope < size, t, step, doubt};
}

/// The nearest hit of a ray whose line surely meets a face at `root`; or, where t is infinite, nowhere. A
/// root on an end of the interval is not sure, since the exact t may lie on either side; nor is one on the
/// other side of t_min than t, by which the face was chosen.
template <class N>
[[nodiscard]] constexpr Corrected<N> nearest_root(const Ray<N>& ray, const Corrected<N>& root) {
  const Mask<N> is_miss = root.t == N(infinity<N>);
  const Mask<N> is_on_one_side = N(0) < (root.answer - ray.t_min) * (root.t - ray.t_min);
  const Mask<N> is_off_end = root.answer < ray.t_max || ray.t_max < root.answer;
  return {select(in_interval(ray, root.answer) && !is_miss, root.answer, N(infinity<N>)),
          (root.is_sure && is_on_one_side && is_off_end) || is_miss, root.t, root.step, root.doubt};
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
