#pragma once
/// \file
/// What a ray and a sphere come to: a quadratic in t, everything that is asked about a given t, and the exact
/// verdict. The formulas stand here once, over a ring R; they run over Interval, Ball and Pair, which know
/// when they can't decide, and then over the exact Ring, which always can.

#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

#include "oracle/geometry/scene.hpp"
#include "oracle/numbers/reading.hpp"
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

[[nodiscard]] inline ExactQuadratic quadratic_of(const SphereEquation<Ring>& scene) {
  return {scene.a(), scene.h(), scene.c()};
}

/// Which roots lie in the ray's interval, and a quarter of the discriminant to one part in 2^20 (an exact 0
/// is 0).
template <class Number>
struct Truth {
  bool lower = false;
  bool upper = false;
  Number discriminant{0};
  Number a{0};

  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(lower) + static_cast<std::size_t>(upper);
  }
  /// The side of the hit that comes `index`-th.
  [[nodiscard]] int side(std::size_t index) const { return index > 0 || !lower ? 1 : -1; }
};

/// A ring's value as a `Number`: as `read` has it, or rounded to a double where doubles serve.
template <class Number, class R>
[[nodiscard]] Number read_as(const R& x) {
  if constexpr (std::is_same_v<R, Ring> && std::is_same_v<Number, double>)
    return x.to_double();
  else
    return read(x);
}

/// The exact verdict, or nothing where R can't decide.
template <class Number, class R>
[[nodiscard]] auto verdict(const SphereEquation<R>& scene, const Ray<double>& ray) {
  using std::abs;
  using Maybe = std::optional<Truth<Number>>;
  const R a = scene.a(), h = scene.h(), c = scene.c();
  const R discriminant = h * h - a * c;
  const auto discriminant_sign = certain_sign(discriminant);
  if (!discriminant_sign) return Maybe();
  Truth<Number> truth{*discriminant_sign >= 0, *discriminant_sign > 0, read_as<Number>(discriminant),
                      read_as<Number>(a)};
  if (uncertainty(discriminant) > 0x1p-20 * abs(value(truth.discriminant))) return Maybe();
  for (const auto& [end, inside] : {std::pair{ray.t_min, 1}, std::pair{ray.t_max, -1}}) {
    if (std::isinf(end)) continue;
    const PowerAt<R> at = end == 0 ? PowerAt<R>{c, h} : scene.at(end);
    const auto power = certain_sign(at.power);
    const auto slope = certain_sign(at.slope);
    if (!power || !slope) return Maybe();
    truth.lower = truth.lower && compare_root(-1, *power, *slope) * inside >= 0;
    truth.upper = truth.upper && compare_root(1, *power, *slope) * inside >= 0;
  }
  return Maybe(truth);
}

}  // namespace rayproof::oracle
