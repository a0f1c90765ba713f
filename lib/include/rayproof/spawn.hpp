#pragma once
/// \file
/// Leaving a surface: from a hit to the origin of the next ray.
///
/// \code
/// const rayproof::Sphere<float> sphere{{0, 0, 5}, 1};
/// const auto surface = rayproof::spawn::surface_of(sphere);
/// const rayproof::Ray<float> ray{{0, 0, 0}, {0, 0, 1}};
/// const auto from = rayproof::spawn::leave(surface, rayproof::point_at(ray, 4.0F));
/// const auto shadow_ray = rayproof::spawn::next_ray<rayproof::spawn::Proven>(
///     from, rayproof::spawn::Side::front, glm::vec3(1, 0, -1));
/// assert(shadow_ray.origin.z < 4);
/// \endcode
///
/// How to choose one: docs/leaving-the-surface.md.

#include <rayproof/ray.hpp>
#include <rayproof/spawn/strategies.hpp>
#include <rayproof/spawn/surfaces.hpp>

namespace rayproof::spawn {

/// The ray along `direction` that leaves the surface to `side`, from where the strategy starts it.
template <class Strategy, class T>
[[nodiscard]] constexpr Ray<T> next_ray(const SurfacePoint<T>& from, Side side, const vec3<T>& direction) {
  return {Strategy::origin(towards(side, from)), direction};
}

}  // namespace rayproof::spawn
