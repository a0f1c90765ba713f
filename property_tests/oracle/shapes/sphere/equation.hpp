#pragma once
/// \file
/// What a ray and a sphere come to: a quadratic in t, the lengths that the contract speaks of, and the exact
/// verdict. The formulas stand here once, over a ring R; they run over Interval, Estimate and Pair, which
/// know when they can't decide, and then over the exact Ring, which always can.

#include <algorithm>
#include <optional>
#include <utility>

#include "oracle/geometry/sizes.hpp"
#include "oracle/numbers/root.hpp"
#include "oracle/numbers/ulp.hpp"

namespace rayproof::oracle {

/// At a given t: the power of the point p(t) with respect to the sphere, and half its derivative by t. The
/// lower and upper root r₋, r₊ of the power satisfy slope = ±√D, and D = slope² - a·power at every t.
template <class R>
struct PowerAt {
  R power, slope;
};

/// The sphere |q - center| = radius and the ray's line, relative to the centre and scaled as ObjectRay says.
template <class R>
struct SphereEquation {
  ObjectRay<R> ray;
  Vector<R> from_center;  ///< scale · (o' - center)
  R radius;               ///< scale · radius; its sign does not matter

  /// Of a RayQuestion, or of its ObjectRay.
  template <class From>
  SphereEquation(const From& from, const Sphere<double>& sphere)
      : ray(from), from_center(Vector<R>::from(sphere.center)), radius(sphere.radius) {
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

/// log2, rounded down to a whole number.
[[nodiscard]] inline double log2_of(double x) {
  return x > 0 ? static_cast<double>(exponent_of(x)) : -HUGE_VAL;
}
[[nodiscard]] inline double log2_of(const Scaled& x) {
  return x.sign() == 0 ? -HUGE_VAL : static_cast<double>(x.exponent() - 1);
}

/// What the judgement says of lengths, and what it measures them by.
template <class Number>
struct SphereSizes {
  Number unit;  ///< S times the transform's condition, in the scale of the equation
  double far, smallest, largest;

  /// S = |origin - center| + radius, as large as a transform makes its parts.
  SphereSizes(const Number& size, const Number& radius, const Number& condition, const Number& shortest,
              const Number& longest)
      : unit(size * condition),
        far(Number(0) < radius ? value(size / radius) : HUGE_VAL),
        smallest(log2_of(shortest)),
        largest(log2_of(longest)) {}
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

/// Which roots lie in the ray's interval, and a quarter of the discriminant to one part in 2^20.
struct Truth {
  bool lower, upper;
  bool is_tangent;  ///< the discriminant is 0
  double discriminant, a;

  [[nodiscard]] std::size_t count() const { return std::size_t{lower} + std::size_t{upper}; }
  /// The side of the hit that comes `index`-th.
  [[nodiscard]] int side(std::size_t index) const { return index > 0 || !lower ? 1 : -1; }
};

/// The exact verdict, or nothing where R can't decide.
template <class R>
[[nodiscard]] std::optional<Truth> verdict(const SphereEquation<R>& scene, const Ray<double>& ray) {
  const R a = scene.a(), h = scene.h(), c = scene.c();
  const R discriminant = h * h - a * c;
  const auto side = certain_sign(discriminant);
  if (!side) return std::nullopt;
  Truth truth{*side >= 0, *side > 0, *side == 0, value(read(discriminant)), value(read(a))};
  if (uncertainty(discriminant) > 0x1p-20 * std::abs(truth.discriminant)) return std::nullopt;
  for (const auto& [end, inside] : {std::pair{ray.t_min, 1}, std::pair{ray.t_max, -1}}) {
    if (std::isinf(end)) continue;
    const PowerAt<R> at = end == 0 ? PowerAt<R>{c, h} : scene.at(end);
    const auto power = certain_sign(at.power);
    const auto slope = certain_sign(at.slope);
    if (!power || !slope) return std::nullopt;
    truth.lower = truth.lower && compare_root(-1, *power, *slope) * inside >= 0;
    truth.upper = truth.upper && compare_root(1, *power, *slope) * inside >= 0;
  }
  return truth;
}

/// The error of a claimed t against the root on `side`, and the distance of p(t) from the surface in units of
/// `unit`.
struct HitError {
  double ulp, residual;
};

/// The error of a finite t; nothing where estimates can't decide.
[[nodiscard]] inline std::optional<HitError> hit_error(const SphereEquation<Estimate>& scene,
                                                       const Truth& truth, double unit, int side, double t,
                                                       Precision precision) {
  const PowerAt<Estimate> at = scene.at(t);
  const double power = read(at.power), slope = read(at.slope);
  const double w = std::sqrt(std::abs(truth.discriminant));
  const double u = side > 0 ? slope : -slope;
  const double sum = std::abs(u) + w;
  // root - t, by the branch that does not cancel: from the slope at a double root, from the power beside a
  // single one.
  const bool by_power = !truth.is_tangent && u > 0;
  if (by_power && uncertainty(at.slope) > 0x1p-20 * sum) return std::nullopt;
  const double to_root = by_power ? (side > 0 ? -power : power) / sum : (side > 0 ? w - u : u - w) / truth.a;
  const double ulp = ulp_of(t + to_root, precision);
  const double of_slope = uncertainty(at.slope) / truth.a;
  const double doubt = by_power ? uncertainty(at.power) / sum + 0x1p-20 * of_slope : of_slope;
  if (!(doubt <= std::max(0x1p-20 * std::abs(to_root), 0x1p-30 * ulp))) return std::nullopt;
  return HitError{std::abs(to_root) / ulp,
                  std::abs(power) / (far_side(power, std::abs(read(scene.radius))) * unit)};
}

}  // namespace rayproof::oracle
