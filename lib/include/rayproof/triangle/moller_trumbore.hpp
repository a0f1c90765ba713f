#pragma once
#include <rayproof/method/method.hpp>
#include <rayproof/triangle.hpp>
#include <rayproof/triangle/barycentric.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::triangle {

/// t, u and v from two cross products, without the triangle's normal; from either side, without a branch.
///
/// The fewest operations of all, and the numerators of u and v share theirs with D. Each triangle judges its
/// edges by its own rounded numbers, so a ray can slip between two triangles that share an edge.
struct MollerTrumbore {
  static constexpr const char* name = "moller_trumbore";
  static constexpr const char* title = "Möller–Trumbore, two-sided and branch-free";
  static constexpr Source source{"T. Möller, B. Trumbore", "Fast, Minimum Storage Ray/Triangle Intersection",
                                 1997};
  static constexpr Contract contract{
      .standing = Standing::naive,
      .verdict = {.measured = 5.96, .promised = triangle_divided_bound, .far_power = 1},
      .residual = {.measured = 3.35, .promised = triangle_robust_bound},
      .hit = triangle_hit_bounds,
      .holds = always_claimed | hit_claims |
               Claims{Claim::coordinates, Claim::verdict, Claim::residual, Claim::moved, Claim::scaled,
                      Claim::reversed, Claim::bounded, Claim::exact},
      .refuted = {{{Claim::robust, triangle_divisor_vanishes}}}};

  static constexpr Step find_u{
      "Find u from s = o − a",
      "u is a quotient of two volumes: D with s in the place of e₁, over D: u = s·(d × e₂) / D."};
  static constexpr Step find_v{
      "Find v and t from s × e₁",
      "q is perpendicular to s and e₁. v = d·(s × e₁) / D and t = e₂·(s × e₁) / D are quotients of volumes."};

  template <class T>
  [[nodiscard]] static constexpr FlatHit<T> roots(const Ray<T>& ray, const Triangle<T>& triangle) {
    step<T>(
        "Form the edges from a, and the direction across one of them",
        "e₁ leads from a to b. e₂ leads from a to c. p = d × e₂ is perpendicular to the ray and to e₂. D = "
        "e₁·(d × e₂) is the volume that e₁, d and e₂ span: 0 where the ray is parallel to the triangle.");
    const vec3<T> e1 = named("e₁", triangle.b - triangle.a);
    const vec3<T> e2 = named("e₂", triangle.c - triangle.a);
    const vec3<T> p = named("p", cross(ray.direction, e2));
    const T D = named("D", dot(e1, p));

    step<T>(find_u);
    const vec3<T> s = named("s", ray.origin - triangle.a);
    const T u = named("u", dot(s, p) / D);

    step<T>(find_v);
    const vec3<T> q = named("q", cross(s, e1));
    const T v = named("v", dot(ray.direction, q) / D);
    const T t = named("t", dot(e2, q) / D);

    return hit_by_parameters(D, t, u, v);
  }
};

}  // namespace rayproof::triangle

#include <rayproof/rounding/as_before.hpp>
