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
