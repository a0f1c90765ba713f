#pragma once
#include <rayproof/method/method.hpp>
#include <rayproof/plane/parametric.hpp>
#include <rayproof/triangle.hpp>
#include <rayproof/triangle/barycentric.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::triangle {

/// a + u·(b-a) + v·(c-a) = o + t·d by Cramer's rule, inside where u >= 0, v >= 0 and u + v <= 1.
///
/// Each triangle judges its edges by its own rounded numbers, so a ray can slip between two triangles that
/// share an edge.
struct Cramer {
  static constexpr const char* name = "cramer";
  static constexpr const char* title = "parametric plane by Cramer's rule";
  static constexpr Source source = sources::ban;
  static constexpr Contract contract{
      .standing = Standing::naive,
      .verdict = {.measured = 3.87, .promised = triangle_divided_bound, .far_power = 1},
      .residual = {.measured = 2.36, .promised = triangle_robust_bound},
      .hit = triangle_hit_bounds,
      .holds = always_claimed | hit_claims |
               Claims{Claim::coordinates, Claim::verdict, Claim::residual, Claim::moved, Claim::scaled,
                      Claim::reversed, Claim::bounded, Claim::exact},
      .refuted = {{{Claim::robust, triangle_divisor_vanishes}}}};

  template <class T>
  [[nodiscard]] static constexpr FlatHit<T> roots(const Ray<T>& ray, const Triangle<T>& triangle) {
    const auto [u, v] = edges_from_a(triangle);
    const auto [D, t, alpha, beta] = plane::meet_by_cramer(ray, triangle.a, u, v);
    return hit_by_parameters(D, t, alpha, beta);
  }
};

}  // namespace rayproof::triangle

#include <rayproof/rounding/as_before.hpp>
