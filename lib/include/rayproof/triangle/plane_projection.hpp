#pragma once
#include <rayproof/method/method.hpp>
#include <rayproof/triangle/barycentric.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::triangle {

/// The point where the ray meets the triangle's plane, then its barycentric coordinates in the projection
/// along the normal's largest axis.
///
/// t is as good as any; but the rounding of the point, which for a ray that grazes the plane or a triangle
/// thin as a needle is large beside the triangle, decides whether it counts. Two triangles with one edge
/// round that point apart, so a ray can slip between them.
struct PlaneProjection {
  static constexpr const char* name = "plane_projection";
  static constexpr const char* title = "plane, then barycentric coordinates in a projection";
  static constexpr Source source = sources::ban;
  static constexpr Contract contract{
      .standing = Standing::naive,
      .verdict = {.measured = 1.86, .promised = triangle_divided_bound, .far_power = 1},
      .residual = {.measured = 2.43, .promised = triangle_robust_bound},
      .hit = {triangle_hit_bounds.point, triangle_hit_bounds.normal},
      .holds = always_claimed | hit_claims |
               Claims{Claim::verdict, Claim::residual, Claim::moved, Claim::scaled, Claim::reversed,
                      Claim::bounded, Claim::exact},
      .refuted = {{{Claim::robust, triangle_divisor_vanishes}}}};

  template <class T>
  [[nodiscard]] static constexpr FlatHit<T> roots(const Ray<T>& ray, const Triangle<T>& triangle) {
    const auto [t, q, a, b, c] = meet_and_project(ray, triangle);

    step<T>("Find the barycentric coordinates in the projection",
            "Each is the area of the triangle that q makes with the side opposite its vertex, over the whole "
            "area; q is inside where none is negative.");
    return hit_inside(t, barycentric(q, a, b, c));
  }
};

}  // namespace rayproof::triangle

#include <rayproof/rounding/as_before.hpp>
