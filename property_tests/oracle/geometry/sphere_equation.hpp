#pragma once
/// \file
/// What a ray and a sphere come to in a ring: a quadratic in t, and everything that is asked about a given t.

#include "oracle/geometry/scene.hpp"

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
  Vector<R> from_center;  ///< scale · (o' - center)
  Vector<R> direction;
  R radius;  ///< scale · radius; its sign does not matter

  SphereEquation(const ObjectRay<R>& ray, const Sphere<double>& sphere)
      : from_center(Vector<R>::from(sphere.center)), direction(ray.direction), radius(sphere.radius) {
    if (ray.map) {  // nearly never, and four exact products otherwise
      from_center = ray.scale * from_center;
      radius = ray.scale * radius;
    }
    from_center = ray.origin - from_center;
  }

  [[nodiscard]] R a() const { return dot(direction, direction); }
  [[nodiscard]] R h() const { return dot(from_center, direction); }
  [[nodiscard]] R c() const { return dot(from_center, from_center) - radius * radius; }

  [[nodiscard]] PowerAt<R> at(double t) const {
    const Vector<R> p = from_center + R(t) * direction;
    return {dot(p, p) - radius * radius, dot(p, direction)};
  }
};

}  // namespace rayproof::oracle
