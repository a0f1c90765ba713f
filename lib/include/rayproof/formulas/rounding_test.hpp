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

/// Two roots and what is known of them: where `is_sure`, the discriminant has the exact sign and is not 0,
/// and each root, if there are any, is within its error less two roundings of the larger root, which the test
/// makes. An error of 0 is that of a root that is a float; a lower root that is NaN stands for none.
template <class W>
struct Enclosed {
  Roots<W> roots;
  W lo_error, hi_error;
  Mask<W> is_sure;
};

/// The hit of a flat figure and what is known of it: where `is_sure`, hit or miss is the exact verdict, and
/// the numbers of a hit are within their errors less two roundings.
template <class W>
struct EnclosedHit {
  FlatHit<W> hit;
  W t_error, u_error, v_error;
  Mask<W> is_sure;
};

/// An answer whose numbers are floats, and where it is sure to be the exact one correctly rounded.
template <class W, class Answer>
struct Quick {
  Answer answer;
  Mask<W> is_sure;
};

/// The float that all numbers within `error` of x are rounded to; 0 is +0. Nothing that has a NaN in it is
/// sure.
template <class W>
[[nodiscard]] constexpr Quick<W, W> rounding_test(const W& x, const W& error) {
  const W low = to_nearest_float(x - error) + W(0);
  return {low, low == to_nearest_float(x + error)};
}

/// The same of a ray's t. An end of the ray's interval is not sure, unless the error is 0: there the exact t
/// may lie on either side.
template <class W>
[[nodiscard]] constexpr Quick<W, W> rounding_test(const Ray<W>& ray, const W& t, const W& error) {
  const auto [answer, is_sure] = rounding_test(t, error);
  const Mask<W> is_off_ends = !(answer == ray.t_min) && !(answer == ray.t_max);
  return {answer, is_sure && (is_off_ends || error == W(0))};
}

/// Both roots.
template <class W>
[[nodiscard]] constexpr Quick<W, Roots<W>> rounded_roots(const Ray<W>& ray, const Enclosed<W>& wide) {
  const Mask<W> is_hit = W(0) < wide.roots.discriminant;
  const auto lo = rounding_test(ray, wide.roots.lo, wide.lo_error);
  const auto hi = rounding_test(ray, wide.roots.hi, wide.hi_error);
  return {{select(is_hit, W(1), W(-1)), select(is_hit, lo.answer, W(not_a_number<W>)),
           select(is_hit, hi.answer, W(not_a_number<W>))},
          wide.is_sure && (!is_hit || ((lo.is_sure || wide.roots.lo != wide.roots.lo) && hi.is_sure))};
}

/// The hit of a flat figure: t and its place in the figure.
template <class W>
[[nodiscard]] constexpr Quick<W, FlatHit<W>> rounded_roots(const Ray<W>& ray, const EnclosedHit<W>& wide) {
  const Mask<W> is_hit = wide.hit.discriminant == W(0);
  const auto t = rounding_test(ray, wide.hit.lo, wide.t_error);
  const auto u = rounding_test(wide.hit.u, wide.u_error);
  const auto v = rounding_test(wide.hit.v, wide.v_error);
  const W there = select(is_hit, t.answer, W(not_a_number<W>));
  return {
      {{wide.hit.discriminant, there, there}, select(is_hit, u.answer, W(0)), select(is_hit, v.answer, W(0))},
      wide.is_sure && (!is_hit || (t.is_sure && u.is_sure && v.is_sure))};
}

/// The nearest hit alone, as `nearest`: the upper root is looked at where the lower one surely lies before
/// the interval.
template <class W>
[[nodiscard]] constexpr Quick<W, W> rounded_nearest(const Ray<W>& ray, const Enclosed<W>& wide) {
  const auto& [discriminant, lo, hi] = wide.roots;
  const Mask<W> is_hit = W(0) < discriminant;
  const Mask<W> is_before = !(ray.t_min <= lo);
  const auto [t, is_t_sure] =
      rounding_test(ray, select(is_before, hi, lo), select(is_before, wide.hi_error, wide.lo_error));
  const Mask<W> is_choice_sure = !is_before || !(ray.t_min <= lo + wide.lo_error);
  return {select(is_hit && in_interval(ray, t), t, W(infinity<W>)),
          wide.is_sure && (!is_hit || (is_t_sure && is_choice_sure))};
}

/// The same of a flat figure.
template <class W>
[[nodiscard]] constexpr Quick<W, W> rounded_nearest(const Ray<W>& ray, const EnclosedHit<W>& wide) {
  const Mask<W> is_hit = wide.hit.discriminant == W(0);
  const auto [t, is_t_sure] = rounding_test(ray, wide.hit.lo, wide.t_error);
  return {select(is_hit && in_interval(ray, t), t, W(infinity<W>)), wide.is_sure && (!is_hit || is_t_sure)};
}

/// The same roots as floats, which they are.
[[nodiscard]] inline Roots<float> as_floats(const Roots<double>& roots) {
  return {static_cast<float>(roots.discriminant), static_cast<float>(roots.lo), static_cast<float>(roots.hi)};
}

[[nodiscard]] inline FlatHit<float> as_floats(const FlatHit<double>& hit) {
  const Roots<double>& roots = hit;
  return {as_floats(roots), static_cast<float>(hit.u), static_cast<float>(hit.v)};
}

/// A method's roots of a ray in float by its quick phase, `enclosed`, in double, where that is sure; else,
/// and of a ray in double, by its `exact_roots`.
template <class Method, std::floating_point T, template <class> class Shape>
[[nodiscard]] auto quick_or_exact_roots(const Ray<T>& ray, const Shape<T>& shape) {
  if constexpr (sizeof(T) < sizeof(double)) {
    const Ray<double> wide_ray = convert<double>(ray);
    const auto quick = rounded_roots(wide_ray, Method::enclosed(wide_ray, convert<double>(shape)));
    if (quick.is_sure) return as_floats(quick.answer);
  }
  return Method::exact_roots(ray, shape);
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
