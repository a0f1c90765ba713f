#pragma once
/// \file
/// Whether plain numbers are finite. The exact methods ask first: an expansion has no sign for a NaN.

#include <cmath>
#include <concepts>
#include <rayproof/vec3.hpp>
#include <vector>

namespace rayproof {

/// Neither infinite nor NaN, nor is any coordinate.
template <std::floating_point T>
[[nodiscard]] inline bool is_finite(T x) {
  return std::isfinite(x);
}
template <std::floating_point T>
[[nodiscard]] inline bool is_finite(const Vec2<T>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y);
}
template <std::floating_point T>
[[nodiscard]] inline bool is_finite(const glm::vec<3, T>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
template <class Point>
[[nodiscard]] inline bool is_finite(const std::vector<Point>& points) {
  for (const Point& point : points) {
    if (!is_finite(point)) return false;
  }
  return true;
}

/// Whether every one of them is.
template <class... Parts>
[[nodiscard]] inline bool are_finite(const Parts&... parts) {
  return (is_finite(parts) && ...);
}

}  // namespace rayproof
