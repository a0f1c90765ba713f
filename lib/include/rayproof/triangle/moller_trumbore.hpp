#pragma once
#include <rayproof/method/contract.hpp>
#include <rayproof/method/narration.hpp>
#include <rayproof/triangle.hpp>

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
  static constexpr int far_power = 0;
  static constexpr Contract contract{
      .verdict = {.measured = 0.828, .promised = triangle_robust_bound},
      .residual = {.measured = 1.32, .promised = triangle_robust_bound},
      .holds = always_claimed | Claims{Claim::verdict, Claim::residual, Claim::robust, Claim::moved,
                                       Claim::scaled, Claim::reversed, Claim::bounded}};

  template <class T>
  [[nodiscard]] static constexpr FlatHit<T> roots(const Ray<T>& ray, const Triangle<T>& triangle) {
    step<T>("Form the edges from a, and the direction across one of them");
    const vec3<T> e1 = named("e₁", triangle.b - triangle.a);
    const vec3<T> e2 = named("e₂", triangle.c - triangle.a);
    const vec3<T> p = named("p", cross(ray.direction, e2));
    const T D = named("D", dot(e1, p));

    step<T>("Find u from the way between the origin and a");
    const vec3<T> s = named("s", ray.origin - triangle.a);
    const T u = named("u", dot(s, p) / D);

    step<T>("Find v and t from the same way across the other edge");
    const vec3<T> q = named("q", cross(s, e1));
    const T v = named("v", dot(ray.direction, q) / D);
    const T t = named("t", dot(e2, q) / D);

    step<T>("Ask whether the point lies in the triangle");
    const Mask<T> is_inside = u >= T(0) && v >= T(0) && u + v <= T(1);
    return flat_hit(D != T(0) && is_inside, t, u, v);
  }
};

}  // namespace rayproof::triangle
