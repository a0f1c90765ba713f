#pragma once
#include <rayproof/plane/point_normal.hpp>
#include <rayproof/triangle.hpp>
#include <rayproof/triangle/barycentric.hpp>

namespace rayproof::triangle {

/// Where a ray meets the plane of a triangle.
template <class T>
struct InPlane {
  T t;             ///< NaN where the ray is parallel to the plane
  vec3<T> point;   ///< p(t), rounded
  vec3<T> normal;  ///< (b-a)×(c-a)
};

template <class T>
[[nodiscard]] constexpr InPlane<T> meet_plane(const Ray<T>& ray, const Triangle<T>& triangle) {
  step<T>("Form the normal of the triangle",
          "n is perpendicular to both edges, and its length is twice the area.");
  const vec3<T> n = named("n", cross(triangle.b - triangle.a, triangle.c - triangle.a));
  const T t = plane::meet(ray, triangle.a, n).lo;
  return {t, named("q", point_at(ray, t)), n};
}

/// A hit at t where the barycentric coordinates are those of a point of the triangle.
template <class T>
[[nodiscard]] constexpr FlatHit<T> hit_inside(const T& t, const Barycentric<T>& w) {
  return flat_hit(is_inside(w), t, w.beta, w.gamma);
}

}  // namespace rayproof::triangle
