#pragma once
/// \file
/// The rounding test of the methods `rounded`: whether an answer that was computed in double, with a bound on
/// its error, rounds to one float whatever the exact one is. Where it may not, exact arithmetic decides.
///
/// `W` is double or a pack of them. Source: A. Ziv, "Fast Evaluation of Elementary Mathematical Functions
/// with Correctly Rounded Last Bit", 1991.

#include <rayproof/roots.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// The two roots of a second-degree problem, and what is known of them: where `is_sure`, the discriminant has
/// the exact sign and is not 0, and both roots, if there are any, are within `error` less two roundings of
/// the larger one, which the test makes.
template <class W>
struct Enclosed {
  Roots<W> roots;
  W error;
  Mask<W> is_sure;
};

/// An answer whose numbers are floats, and where it is sure to be the exact one correctly rounded.
template <class W, class Answer>
struct Quick {
  Answer answer;
  Mask<W> is_sure;
};

/// The float that all numbers within `error` of t are rounded to. An end of the ray's interval is never sure:
/// there the exact t may lie on either side. Nor is anything that has a NaN in it.
template <class W>
[[nodiscard]] constexpr Quick<W, W> rounding_test(const Ray<W>& ray, const W& t, const W& error) {
  const W low = to_nearest_float(t - error);
  const W high = to_nearest_float(t + error);
  return {low, low == high && !(low == ray.t_min) && !(low == ray.t_max)};
}

/// Both roots.
template <class W>
[[nodiscard]] constexpr Quick<W, Roots<W>> rounded_roots(const Ray<W>& ray, const Enclosed<W>& wide) {
  const Mask<W> is_hit = W(0) < wide.roots.discriminant;
  const auto lo = rounding_test(ray, wide.roots.lo, wide.error);
  const auto hi = rounding_test(ray, wide.roots.hi, wide.error);
  return {{select(is_hit, W(1), W(-1)), select(is_hit, lo.answer, W(not_a_number<W>)),
           select(is_hit, hi.answer, W(not_a_number<W>))},
          wide.is_sure && (!is_hit || (lo.is_sure && hi.is_sure))};
}

/// The nearest hit alone, as `nearest`: the upper root is looked at where the lower one surely lies before
/// the interval.
template <class W>
[[nodiscard]] constexpr Quick<W, W> rounded_nearest(const Ray<W>& ray, const Enclosed<W>& wide) {
  const auto& [discriminant, lo, hi] = wide.roots;
  const Mask<W> is_hit = W(0) < discriminant;
  const Mask<W> is_before = lo < ray.t_min;
  const auto [t, is_t_sure] = rounding_test(ray, select(is_before, hi, lo), wide.error);
  const Mask<W> is_choice_sure = !is_before || lo + wide.error < ray.t_min;
  return {select(is_hit && in_interval(ray, t), t, W(infinity<W>)),
          wide.is_sure && (!is_hit || (is_t_sure && is_choice_sure))};
}

/// The same roots as floats, which they are.
[[nodiscard]] inline Roots<float> as_floats(const Roots<double>& roots) {
  return {static_cast<float>(roots.discriminant), static_cast<float>(roots.lo), static_cast<float>(roots.hi)};
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
