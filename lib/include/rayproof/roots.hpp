#pragma once
/// \file
/// What a second-degree problem comes to: the sign of its discriminant and two roots.

#include <optional>
#include <rayproof/arithmetic.hpp>
#include <rayproof/ray.hpp>

namespace rayproof {

/// Two roots, ascending, and a number with the discriminant's sign: negative (or NaN) for no real root, 0 for
/// one double root (`lo == hi`), positive for two. Where there is no real root, `lo` and `hi` are NaN, so
/// that every comparison with them is false.
template <class T>
struct Roots {
  T discriminant;
  T lo;
  T hi;
};

/// The one hit of a flat figure, and where on it: `u` and `v` are the second and third barycentric coordinate
/// in a triangle (p = (1-u-v)·a + u·b + v·c), the parameters of a parametric plane (p = point + u·u + v·v).
/// As roots: discriminant 0 and `lo == hi == t` where there is a hit, -1 and NaN where there is none.
template <class T>
struct FlatHit : Roots<T> {
  T u;
  T v;
};

/// Neither root, and no hit: what an exact method answers without a computation.
template <Branching T>
inline constexpr Roots<T> no_roots{T(-1), T(not_a_number<T>), T(not_a_number<T>)};
template <Branching T>
inline constexpr FlatHit<T> no_hit{no_roots<T>, T(0), T(0)};

/// A hit at t.
template <class T>
[[nodiscard]] constexpr FlatHit<T> hit_at(const T& t, const T& u, const T& v) {
  return {{T(0), t, t}, u, v};
}

/// A hit at t where `is_hit`, none elsewhere. `is_hit` false and a NaN for t mean the same; so does a t that
/// overflows, since what it was divided by is all rounding: the ray may be parallel as well.
template <class T>
[[nodiscard]] constexpr FlatHit<T> flat_hit(const Mask<T>& is_hit, const T& t, const T& u, const T& v) {
  const Mask<T> is_there = is_hit && abs(t) < T(infinity<T>);
  const T there = select(is_there, t, T(not_a_number<T>));
  return {{select(is_there, T(0), T(-1)), there, there}, u, v};
}

/// What a convex solid cuts out of the line: [entry, exit] where entry <= exit, nothing where entry > exit or
/// one of them is NaN. As roots: the discriminant is exit - entry, 0 where the solid is touched at one t.
template <class T>
[[nodiscard]] constexpr Roots<T> chord(const T& entry, const T& exit) {
  const Mask<T> is_hit = entry <= exit;
  const T D = select(entry == exit, T(0), exit - entry);
  return {select(is_hit, D, T(-1)), select(is_hit, entry, T(not_a_number<T>)),
          select(is_hit, exit, T(not_a_number<T>))};
}

/// Puts two roots in order; NaN roots stay NaN.
template <class T>
[[nodiscard]] constexpr Roots<T> ascending(const T& discriminant, const T& x0, const T& x1) {
  const Mask<T> swapped = x1 < x0;
  return {discriminant, select(swapped, x1, x0), select(swapped, x0, x1)};
}

/// Nearest hit: the smallest root in the ray's interval, or +infinity for a miss.
template <class T>
[[nodiscard]] constexpr T nearest(const Ray<T>& ray, const Roots<T>& roots) {
  const T far = select(in_interval(ray, roots.hi), roots.hi, T(infinity<T>));
  return select(in_interval(ray, roots.lo), roots.lo, far);
}

/// Any hit: whether the ray's interval holds a root at all.
template <class T>
[[nodiscard]] constexpr Mask<T> any(const Ray<T>& ray, const Roots<T>& roots) {
  return in_interval(ray, roots.lo) || in_interval(ray, roots.hi);
}

}  // namespace rayproof
