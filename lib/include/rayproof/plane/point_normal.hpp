#pragma once
#include <rayproof/method/method.hpp>
#include <rayproof/plane/forms.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::plane {

/// The t at which a ray meets the plane through `point` with the normal `n`: n·(point - o) / (n·d); none
/// where n·d = 0.
template <class T>
[[nodiscard]] constexpr FlatHit<T> meet(const Ray<T>& ray, const vec3<T>& point, const vec3<T>& n) {
  step<T>("Divide the distance by the ray's progress",
          "p is a point of the plane: the vertex a of a triangle, v₀ of a polygon. n·(p - o) is the "
          "signed distance from o to the plane, times |n|. n·d is what the ray gains along n in each "
          "unit of t, times |n| too. t is the quotient of the two; where the ray gains nothing, there is "
          "no single t.");
  const T distance = named("n·(p - o)", dot(n, point - ray.origin));
  const T along = named("n·d", dot(n, ray.direction));
  return flat_hit(along != T(0), named("t", distance / along), T(0), T(0));
}

/// t = n·(p - o) / (n·d) for a point p of the plane.
///
/// A ray with n·d = 0 is parallel to the plane or runs inside it: a miss.
struct ByPointAndNormal {
  static constexpr const char* name = "point_normal";
  static constexpr const char* title = "a point of the plane and its normal";
  static constexpr Source source = sources::ban;
  static constexpr Contract contract{
      .verdict = {.measured = 2.14, .promised = plane_robust_bound, .is_proven = true},
      .residual = {.measured = 4.54, .promised = plane_robust_bound, .is_proven = true},
      .hit = {plane_hit_bounds.point, plane_hit_bounds.normal},
      .holds = robust_claims | hit_claims | Claims{Claim::residual, Claim::bounded}};

  template <class T>
  [[nodiscard]] static constexpr FlatHit<T> roots(const Ray<T>& ray, const Plane<T>& plane) {
    const auto [point, normal] = as_point_normal(plane);
    return meet(ray, point, normal);
  }
};

}  // namespace rayproof::plane

#include <rayproof/rounding/as_before.hpp>
