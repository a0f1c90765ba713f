#pragma once
/// \file
/// The lengths that the contract of ray and sphere speaks of.

#include <algorithm>
#include <cmath>

#include "oracle/geometry/sizes.hpp"
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

}  // namespace rayproof::oracle
