#pragma once
/// \file
/// The ray: a point, a direction, and the closed interval of t in which hits count.

#include <rayproof/arithmetic.hpp>
#include <rayproof/vec3.hpp>

namespace rayproof {

/// The points p(t) = origin + t * direction for t in the *closed* interval [t_min, t_max].
/// `direction` need not be a unit vector: t counts direction lengths. A segment is [0, 1]; a whole line
/// [-inf, inf].
template <class T>
struct Ray {
  vec3<T> origin;
  vec3<T> direction;
  T t_min = T(0);
  T t_max = T(infinity<T>);
};
template <class T>
Ray(glm::vec<3, T>, glm::vec<3, T>) -> Ray<T>;
template <class T>
Ray(glm::vec<3, T>, glm::vec<3, T>, T, T) -> Ray<T>;

/// Whether t counts as a hit of `ray`; false where t or an end of the interval is NaN.
template <class T>
[[nodiscard]] constexpr Mask<T> in_interval(const Ray<T>& ray, const T& t) {
  return ray.t_min <= t && t <= ray.t_max;
}

#include <rayproof/rounding/as_written.hpp>

/// p(t), rounded operation by operation.
template <class T>
[[nodiscard]] constexpr vec3<T> point_at(const Ray<T>& ray, const T& t) {
  return ray.origin + t * ray.direction;
}

#include <rayproof/rounding/as_before.hpp>

/// The same ray in another arithmetic.
template <class To, class From>
[[nodiscard]] constexpr Ray<To> convert(const Ray<From>& ray) {
  return {convert<To>(ray.origin), convert<To>(ray.direction), To(ray.t_min), To(ray.t_max)};
}

}  // namespace rayproof
