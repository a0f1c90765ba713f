#pragma once
#include <rayproof/method/method.hpp>
#include <rayproof/plane/parametric.hpp>
#include <rayproof/triangle.hpp>
#include <rayproof/triangle/barycentric.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::triangle {

/// Cramer with 'inside exactly when 0 <= u <= 1 and 0 <= v <= 1', **as printed** in the source: u + v <= 1 is
/// missing, and the figure is the parallelogram over the triangle.
struct PrintedParallelogram {
  static constexpr const char* name = "printed_parallelogram";
  static constexpr const char* title = "as printed: u and v each in [0, 1], a parallelogram";
  static constexpr Source source = sources::ban;
  static constexpr Contract contract{
      .standing = Standing::printed,
      .residual = {.measured = 1.24, .promised = triangle_robust_bound},
      .holds = always_claimed | Claims{Claim::residual},
      .refuted = {{{Claim::robust, "u + v <= 1 is missing: the other half of the parallelogram is hit too"},
                   {Claim::exact, "the other half of the parallelogram is hit where nothing is rounded"}}}};

  template <class T>
  [[nodiscard]] static constexpr FlatHit<T> roots(const Ray<T>& ray, const Triangle<T>& triangle) {
    const auto [u, v] = edges_from_a(triangle);
    const auto [D, t, alpha, beta] = plane::meet_by_cramer(ray, triangle.a, u, v);

    step<T>("Ask whether α and β lie in [0, 1], as printed",
            "These are the points of a whole parallelogram: the condition α + β ≤ 1 is missing.");
    const Mask<T> is_inside = alpha >= T(0) && alpha <= T(1) && beta >= T(0) && beta <= T(1);
    return flat_hit(D != T(0) && is_inside, t, alpha, beta);
  }
};

}  // namespace rayproof::triangle

#include <rayproof/rounding/as_before.hpp>
