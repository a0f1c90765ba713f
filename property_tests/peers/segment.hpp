#pragma once
/// \file
/// The segment of a ray that a library is given where it takes no ray: from its origin on, beyond the shape
/// at least, and not beyond t_max.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "answer_cases.hpp"

namespace rayproof::peers {

/// The ends of the segment and what it says of t: s·t_end for s in [0, 1].
template <class T>
struct Segment {
  glm::vec<3, T> start, end;
  double t_end;

  /// t of the point at s.
  [[nodiscard]] double t_at(double s) const { return s * t_end; }
};

/// The segment of `ray` that passes everything within `radius` of `center`. Throws Unsupported where it has
/// no length, or its ends no numbers of T, and where the ray does not begin at its origin: t counts from the
/// start of a segment.
template <class T>
[[nodiscard]] Segment<T> segment_past(const Ray<double>& ray, const glm::dvec3& center, double radius,
                                      bool is_flat = false) {
  if (ray.t_min != 0) throw Unsupported();
  const double length = std::hypot(ray.direction.x, ray.direction.y, ray.direction.z);
  const double middle = dot(center - ray.origin, ray.direction / length) / length;
  const double reach = 2 * radius / length;
  // A power of two, so that the segment's numbers are as short as the ray's.
  const double far = std::exp2(std::ceil(std::log2(std::max(middle + reach, reach))));
  const double end = std::min(ray.t_max, far);
  const Segment<T> made{glm::vec<3, T>(ray.origin), glm::vec<3, T>(ray.origin + end * ray.direction), end};
  const auto whole = made.end - made.start;
  const T length2 = dot(whole, whole);
  if (!std::isfinite(length2) || length2 < std::numeric_limits<T>::min()) throw Unsupported();
  for (int axis = 0; axis < 3; ++axis)
    if (!is_flat && whole[axis] != 0 && std::abs(made.start[axis]) > 8 * std::abs(whole[axis]))
      throw Unsupported();
  return made;
}

/// The same past points.
template <class T>
[[nodiscard]] Segment<T> segment_past(const Ray<double>& ray, std::span<const glm::dvec3> points,
                                      bool is_flat = false) {
  glm::dvec3 center(0);
  for (const glm::dvec3& point : points) center += point / static_cast<double>(points.size());
  double radius = 0;
  for (const glm::dvec3& point : points)
    radius = std::max(radius, std::hypot(point.x - center.x, point.y - center.y, point.z - center.z));
  return segment_past<T>(ray, center, radius, is_flat);
}

}  // namespace rayproof::peers
