#pragma once
/// \file
/// What a search along a ray asks of the ray first.

#include <rayproof/formulas/finite.hpp>
#include <rayproof/ray.hpp>

namespace rayproof {

/// Whether there is anything to search: an origin and a direction of finite numbers, not all of the direction
/// 0, and an interval that is not empty. False where any of them is NaN.
template <std::floating_point T>
[[nodiscard]] bool is_searchable(const Ray<T>& ray) {
  const bool is_still = ray.direction.x == 0 && ray.direction.y == 0 && ray.direction.z == 0;
  return !is_still && are_finite(ray.origin, ray.direction) && ray.t_min <= ray.t_max;
}

}  // namespace rayproof
