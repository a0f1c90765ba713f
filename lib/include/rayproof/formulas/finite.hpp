#pragma once
/// \file
/// Whether plain numbers are finite. The exact methods ask first: an expansion has no sign for a NaN.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <rayproof/ray.hpp>
#include <vector>

namespace rayproof {

/// Neither infinite nor NaN, nor is any coordinate.
template <std::floating_point T>
[[nodiscard]] inline bool is_finite(T x) {
  return std::isfinite(x);
}
template <Branching T>
[[nodiscard]] inline bool is_finite(const Vec2<T>& v) {
  return is_finite(v.x) && is_finite(v.y);
}
template <Branching T>
[[nodiscard]] inline bool is_finite(const Vec3<T>& v) {
  return is_finite(v.x) && is_finite(v.y) && is_finite(v.z);
}
template <std::floating_point T>
[[nodiscard]] inline bool is_finite(const glm::vec<3, T>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
template <class Point>
[[nodiscard]] inline bool is_finite(const std::vector<Point>& points) {
  return std::all_of(points.begin(), points.end(), [](const Point& point) { return is_finite(point); });
}

/// Whether every one of them is.
template <class... Parts>
[[nodiscard]] inline bool are_finite(const Parts&... parts) {
  return (is_finite(parts) && ...);
}

/// Whether there is anything to search along a ray: an origin and a direction of finite numbers, not all of
/// the direction 0, and an interval that is not empty. False where any of them is NaN.
template <std::floating_point T>
[[nodiscard]] bool is_searchable(const Ray<T>& ray) {
  const bool is_still = ray.direction.x == 0 && ray.direction.y == 0 && ray.direction.z == 0;
  return !is_still && are_finite(ray.origin, ray.direction) && ray.t_min <= ray.t_max;
}

}  // namespace rayproof
