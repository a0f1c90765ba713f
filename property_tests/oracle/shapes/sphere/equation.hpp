#pragma once
/// \file
/// What a ray and a sphere come to: a quadratic in t, and the lengths that the contract speaks of. The
/// formulas stand here once, over a ring R; they run over Interval, Ball and Pair, which know when they can't
/// decide, and then over the exact Ring, which always can.

#include <algorithm>

#include "oracle/geometry/sizes.hpp"
#include "oracle/numbers/root.hpp"

namespace rayproof::oracle {

/// At a given t: the power of the point p(t) with respect to the sphere, and half its derivative by t. The
/// lower and upper root r₋, r₊ of the power satisfy slope = ±√D, and D = slope² - a·power at every t.
template <class R>
struct PowerAt {
  R power;
  R slope;
};

/// The sphere |q - center| = radius and the ray's line, relative to the centre and scaled as ObjectRay says.
template <class R>
struct SphereEquation {
  ObjectRay<R> ray;
  Vector<R> from_center;  ///< scale · (o' - center)
  R radius;               ///< scale · radius; its sign does not matter

  SphereEquation(const ObjectRay<R>& r, const Sphere<double>& sphere)
      : ray(r), from_center(Vector<R>::from(sphere.center)), radius(sphere.radius) {
    if (ray.map) {  // nearly never, and four exact products otherwise
      from_center = ray.scale * from_center;
      radius = ray.scale * radius;
    }
    from_center = ray.origin - from_center;
  }

  [[nodiscard]] R a() const { return dot(ray.direction, ray.direction); }
  [[nodiscard]] R h() const { return dot(from_center, ray.direction); }
  [[nodiscard]] R c() const { return dot(from_center, from_center) - radius * radius; }

  [[nodiscard]] PowerAt<R> at(double t) const {
    const Vector<R> p = from_center + R(t) * ray.direction;
    return {dot(p, p) - radius * radius, dot(p, ray.direction)};
  }
};

[[nodiscard]] inline RootList roots_of(const SphereEquation<Ring>& scene) {
  return real_roots({scene.a(), scene.h(), scene.c()});
}

/// In the scale of the equation.
template <class Number>
struct SphereSizes {
  Number size;       ///< S = |origin - center| + radius, as large as a transform makes its parts
  Number radius;     ///< of the sphere
  Number condition;  ///< of the transform, 1 without one
  Number smallest, largest;
};

template <class R>
[[nodiscard]] SphereSizes<NumberOf<R>> sizes_of(const SphereEquation<R>& scene, const RayQuestion& question,
                                                const Sphere<double>& sphere) {
  using std::abs;
  using Number = NumberOf<R>;
  const Number radius = abs(read(scene.radius));
  const Number direction = norm(Vector<R>::from(question.ray.direction));
  if (!scene.ray.map) {
    const Number size = norm(scene.from_center) + radius;
    return {size, radius, Number(1), std::min(size, direction), std::max(size, direction)};
  }
  const InverseMap<R>& inverse = *scene.ray.map;
  const MapSizes<R> map(*question.transform, inverse);
  const Number scale = abs(read(scene.ray.scale));
  const Number to_origin = norm(Vector<R>::from(question.ray.origin)) + norm(inverse.translation);
  const Number size = map.backward * to_origin + scale * norm(Vector<R>::from(sphere.center)) + radius;
  const auto all = {size / scale, direction, map.forward, scale / map.backward,
                    norm(scene.ray.direction) / scale};
  return {size, radius, map.forward * map.backward / scale, std::min(all), std::max(all)};
}

/// The distance from the surface is |power| over this sum, the distance from the centre plus the radius.
template <class Number>
[[nodiscard]] Number reach_of(const Number& power, const Number& radius) {
  using std::abs, std::sqrt;
  return sqrt(abs(power + radius * radius)) + radius;
}

}  // namespace rayproof::oracle
