#pragma once
/// \file
/// A surface along a ray: the function of t whose roots are the hits, and the same near infinity.

#include <cmath>
#include <rayproof/arithmetics/dual.hpp>
#include <rayproof/implicit.hpp>

namespace rayproof::implicit {

/// f(origin + t·direction) as a function of t in any arithmetic.
template <class Surface, std::floating_point P>
struct AlongRay {
  const Surface& f;
  const Ray<P>& ray;

  template <class T>
  [[nodiscard]] T operator()(const T& t) const {
    const vec3<T> p = point_at(convert<T>(ray), t);
    if constexpr (Homogeneous<Surface, T>) {
      return f(p.x, p.y, p.z, T(1));
    } else {
      return f(p.x, p.y, p.z);
    }
  }
};

/// f(s·origin + direction, s), which for s = 1/t has the same roots: a root at s = 0 is a direction of the
/// surface at infinity, and no hit.
template <class Surface, std::floating_point P>
struct NearInfinity {
  const Surface& f;
  const Ray<P>& ray;

  template <class T>
  [[nodiscard]] T operator()(const T& s) const {
    const vec3<T> p = s * convert<T>(ray.origin) + convert<T>(ray.direction);
    return f(p.x, p.y, p.z, s);
  }
};

/// A power of two, about the t at which the ray is as far from its origin as the origin from the world's: to
/// either side of it lie the t's that matter and the 1/t's that do.
template <std::floating_point P>
[[nodiscard]] P turning_point(const Ray<P>& ray) {
  const auto largest = [](const vec3<P>& v) { return max(abs(v.x), max(abs(v.y), abs(v.z))); };
  const P apart = exponent(max(largest(ray.origin), P(1))) - exponent(largest(ray.direction));
  constexpr P most = P(std::numeric_limits<P>::max_exponent / 2);
  return scale_exponent(P(1), max(-most, min(most, apart + 2)));
}

}  // namespace rayproof::implicit
