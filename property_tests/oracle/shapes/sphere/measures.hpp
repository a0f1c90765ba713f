#pragma once
/// \file
/// The lengths that the contract of ray and sphere speaks of, and the error of a claimed hit: over the
/// filters' numbers and over the exact ring alike.

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

#include "oracle/geometry/sizes.hpp"
#include "oracle/numbers/ulp.hpp"
#include "oracle/shapes/sphere/equation.hpp"

namespace rayproof::oracle {

/// In the scale of the equation.
template <class Number>
struct SphereSizes {
  Number size;       ///< S = |origin - center| + radius, as large as a transform makes its parts
  Number radius;     ///< of the sphere
  Number condition;  ///< of the transform, 1 without one
  Number smallest, largest;
};

template <class R>
[[nodiscard]] auto sizes_of(const SphereEquation<R>& scene, const ObjectRay<R>& ray,
                            const RayQuestion& question, const Sphere<double>& sphere) {
  using std::abs;
  using Number = NumberOf<R>;
  const Number radius = abs(read(scene.radius));
  const Number direction = norm(Vector<R>::from(question.ray.direction));
  if (!ray.map) {
    const Number size = norm(scene.from_center) + radius;
    return SphereSizes<Number>{size, radius, Number(1), std::min(size, direction), std::max(size, direction)};
  }
  const MapSizes<R> map(*question.transform, *ray.map);
  const Number scale = abs(read(ray.scale));
  const Number to_origin = norm(Vector<R>::from(question.ray.origin)) + norm(ray.map->translation);
  const Number size = map.backward * to_origin + scale * norm(Vector<R>::from(sphere.center)) + radius;
  const auto all = {size / scale, direction, map.forward, scale / map.backward,
                    norm(scene.direction) / scale};
  return SphereSizes<Number>{size, radius, map.forward * map.backward / scale, std::min(all), std::max(all)};
}

/// The error of a claimed t against the root on `side`, and the distance of p(t) from the surface in units of
/// `unit`.
struct HitError {
  double ulp;
  double residual;
};

/// The error of a finite t; nothing where R can't decide.
template <class R, class Number>
[[nodiscard]] std::optional<HitError> hit_error(const SphereEquation<R>& scene, const Truth<Number>& truth,
                                                const Number& unit, int side, double t, Precision precision) {
  using std::abs, std::sqrt;
  const PowerAt<R> at = scene.at(t);
  const Number power = read(at.power);
  const Number slope = read(at.slope);
  const Number w = sqrt(abs(truth.discriminant));
  const Number u = side > 0 ? slope : -slope;
  const Number sum = abs(u) + w;
  const bool is_double = !(Number(0) < w);
  // root - t, by the branch that does not cancel: from the slope at a double root, from the power beside a
  // single one.
  const bool by_power = !is_double && Number(0) < u;
  const Number to_root = by_power ? (side > 0 ? -power : power) / sum : (side > 0 ? w - u : u - w) / truth.a;
  if (by_power && uncertainty(at.slope) > 0x1p-20 * value(sum)) return std::nullopt;
  const double error = value(to_root);
  const double ulp = ulp_of(t + error, precision);
  if constexpr (std::is_same_v<R, Ball>) {
    const double of_slope = uncertainty(at.slope) / truth.a;
    const double doubt = by_power ? uncertainty(at.power) / sum + 0x1p-20 * of_slope : of_slope;
    if (!(doubt <= std::max(0x1p-20 * abs(error), 0x1p-30 * ulp))) return std::nullopt;
  }

  const Number radius = abs(read(scene.radius));
  const Number distance = sqrt(abs(power + radius * radius));
  return HitError{abs(error) / ulp, value(abs(power) / ((distance + radius) * unit))};
}

}  // namespace rayproof::oracle
