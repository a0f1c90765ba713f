#pragma once
/// \file
/// The rounding test of the methods `rounded`: whether an answer that was computed with more digits, and with
/// a bound on its error, rounds to one number whatever the exact one is. Where it may not, exact arithmetic
/// decides.
///
/// `W` is double or a pack of doubles where the answer is a float, and a double-double of either where it is
/// a double. `Leading<W>` is what the answer and all bounds are computed in. Source: A. Ziv, "Fast Evaluation
/// of Elementary Mathematical Functions with Correctly Rounded Last Bit", 1991.

#include <rayproof/arithmetics/double_double.hpp>
#include <rayproof/roots.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// The arithmetic of the quick phase of an answer in T. `N` is double or a pack of doubles.
template <std::floating_point T, class N = double>
using WiderThan = std::conditional_t<sizeof(T) < sizeof(double), N, DoubleDouble<N>>;

/// Two roots and what is known of them: where `is_sure`, the discriminant has the exact sign and is not 0,
/// and each root, if there are any, is within its error less two roundings of the larger root, which the test
/// makes. An error of 0 is that of a root that needs no rounding; a lower root that is NaN stands for none.
template <class W>
struct Enclosed {
  Roots<W> roots;
  Leading<W> lo_error, hi_error;
  Mask<W> is_sure;
};

/// The hit of a flat figure and what is known of it: where `is_sure`, hit or miss is the exact verdict, and
/// the numbers of a hit are within their errors less two roundings.
template <class W>
struct EnclosedHit {
  FlatHit<W> hit;
  Leading<W> t_error, u_error, v_error;
  Mask<W> is_sure;
};

/// An answer in the precision that is asked for, and where it is sure to be the exact one correctly rounded.
template <class W, class Answer>
struct Quick {
  Answer answer;
  Mask<W> is_sure;
};

/// x + more, rounded to the precision of the answer.
template <class W>
[[nodiscard]] constexpr W narrowed(const W& x, const W& more) {
  return to_nearest_float(x + more);
}

/// The number that all numbers within `error` of x are rounded to; 0 is +0. Nothing that has a NaN in it is
/// sure.
template <class W>
[[nodiscard]] constexpr Quick<W, Leading<W>> rounding_test(const W& x, const Leading<W>& error) {
  const Leading<W> low = narrowed(x, -error) + Leading<W>(0);
  return {low, low == narrowed(x, error)};
}

/// The same of a ray's t. An end of the ray's interval is not sure, unless the error is 0: there the exact t
/// may lie on either side.
template <class W>
[[nodiscard]] constexpr Quick<W, Leading<W>> rounding_test(const Ray<Leading<W>>& ray, const W& t,
                                                           const Leading<W>& error) {
  const auto [answer, is_sure] = rounding_test(t, error);
  const Mask<W> is_off_ends = !(answer == ray.t_min) && !(answer == ray.t_max);
  return {answer, is_sure && (is_off_ends || error == Leading<W>(0))};
}

/// Both roots.
template <class W>
[[nodiscard]] constexpr Quick<W, Roots<Leading<W>>> rounded_roots(const Ray<Leading<W>>& ray,
                                                                  const Enclosed<W>& wide) {
  using N = Leading<W>;
  const Mask<W> is_hit = W(0) < wide.roots.discriminant;
  const auto lo = rounding_test(ray, wide.roots.lo, wide.lo_error);
  const auto hi = rounding_test(ray, wide.roots.hi, wide.hi_error);
  return {{select(is_hit, N(1), N(-1)), select(is_hit, lo.answer, N(not_a_number<N>)),
           select(is_hit, hi.answer, N(not_a_number<N>))},
          wide.is_sure && (!is_hit || ((lo.is_sure || wide.roots.lo != wide.roots.lo) && hi.is_sure))};
}

/// The hit of a flat figure: t and its place in the figure.
template <class W>
[[nodiscard]] constexpr Quick<W, FlatHit<Leading<W>>> rounded_roots(const Ray<Leading<W>>& ray,
                                                                    const EnclosedHit<W>& wide) {
  using N = Leading<W>;
  const Mask<W> is_hit = wide.hit.discriminant == W(0);
  const auto t = rounding_test(ray, wide.hit.lo, wide.t_error);
  const auto u = rounding_test(wide.hit.u, wide.u_error);
  const auto v = rounding_test(wide.hit.v, wide.v_error);
  const N there = select(is_hit, t.answer, N(not_a_number<N>));
  return {{{leading(wide.hit.discriminant), there, there},
           select(is_hit, u.answer, N(0)),
           select(is_hit, v.answer, N(0))},
          wide.is_sure && (!is_hit || (t.is_sure && u.is_sure && v.is_sure))};
}

/// The nearest hit alone, as `nearest`: the upper root is looked at where the lower one surely lies before
/// the interval, or is NaN. Of a lower one that may lie on either side of its end no rounding is sure.
template <class W>
[[nodiscard]] constexpr Quick<W, Leading<W>> rounded_nearest(const Ray<Leading<W>>& ray,
                                                             const Enclosed<W>& wide) {
  using N = Leading<W>;
  const auto& [discriminant, lo, hi] = wide.roots;
  const Mask<W> is_hit = W(0) < discriminant;
  const Mask<W> is_lo = ray.t_min <= leading(lo + wide.lo_error);
  const auto [t, is_t_sure] =
      rounding_test(ray, select(is_lo, lo, hi), select(is_lo, wide.lo_error, wide.hi_error));
  return {select(is_hit && in_interval(ray, t), t, N(infinity<N>)), wide.is_sure && (!is_hit || is_t_sure)};
}

/// The same of a flat figure.
template <class W>
[[nodiscard]] constexpr Quick<W, Leading<W>> rounded_nearest(const Ray<Leading<W>>& ray,
                                                             const EnclosedHit<W>& wide) {
  using N = Leading<W>;
  const Mask<W> is_hit = wide.hit.discriminant == W(0);
  const auto [t, is_t_sure] = rounding_test(ray, wide.hit.lo, wide.t_error);
  return {select(is_hit && in_interval(ray, t), t, N(infinity<N>)), wide.is_sure && (!is_hit || is_t_sure)};
}

/// The same roots in another precision, which holds them.
template <class To, class From>
[[nodiscard]] constexpr Roots<To> convert(const Roots<From>& roots) {
  return {To(roots.discriminant), To(roots.lo), To(roots.hi)};
}
template <class To, class From>
[[nodiscard]] constexpr FlatHit<To> convert(const FlatHit<From>& hit) {
  const Roots<From>& roots = hit;
  return {convert<To>(roots), To(hit.u), To(hit.v)};
}

/// Whether a method has a quick phase, which answers most rays, with more digits.
template <class Method>
inline constexpr bool has_quick_phase = requires {
  &Method::template enclosed<double>;
};

/// What a method's quick phase asks of a shape: what the method can find before the ray is known, or the
/// shape as it is.
template <class Method, class Shape>
[[nodiscard]] constexpr auto prepared(const Shape& shape) {
  if constexpr (requires { Method::prepared(shape); }) {
    return Method::prepared(shape);
  } else {
    return shape;
  }
}

/// A method's roots by its quick phase, `enclosed`, where that is sure; else by its `exact_roots`.
template <class Method, std::floating_point T, template <class> class Shape>
[[nodiscard]] auto quick_or_exact_roots(const Ray<T>& ray, const Shape<T>& shape) {
  using W = WiderThan<T>;
  const auto known = Method::enclosed(convert<W>(ray), prepared<Method>(convert<W>(shape)));
  const auto quick = rounded_roots(convert<double>(ray), known);
  return quick.is_sure ? convert<T>(quick.answer) : Method::exact_roots(ray, shape);
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
