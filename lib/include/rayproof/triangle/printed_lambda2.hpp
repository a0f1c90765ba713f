#pragma once
#include <rayproof/method/method.hpp>
#include <rayproof/triangle/barycentric.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::triangle {

/// PlaneProjection with λ₂ = (-(a_y-c_y)(x-c_x) - (a_x-c_x)(y-c_y)) / D, **as printed** in the source: the
/// second sign must be +.
struct PrintedLambda2 {
  static constexpr const char* name = "printed_lambda2";
  static constexpr const char* title = "as printed: a wrong sign in the second barycentric coordinate";
  static constexpr Source source = sources::ban;
  static constexpr Contract contract{
      .standing = Standing::printed,
      .residual = {.measured = 1.03, .promised = triangle_robust_bound},
      .holds = always_claimed | Claims{Claim::residual},
      .refuted = {{{Claim::robust, "the second sign in λ₂ must be +"},
                   {Claim::exact, "the wrong sign is wrong without a rounding, too"}}}};

  template <class T>
  [[nodiscard]] static constexpr FlatHit<T> roots(const Ray<T>& ray, const Triangle<T>& triangle) {
    const auto [t, q, a, b, c] = meet_and_project(ray, triangle);

    step<T>("Find the barycentric coordinates, the second as printed",
            "The second sign in the numerator of λ₂ is wrong: it must be +.");
    const T D = named("D", (b.y - c.y) * (a.x - c.x) - (b.x - c.x) * (a.y - c.y));
    const T as_printed = named("λ₂", (-(a.y - c.y) * (q.x - c.x) - (a.x - c.x) * (q.y - c.y)) / D);
    const T alpha = barycentric(q, a, b, c).alpha;
    return hit_inside(t, Barycentric<T>{alpha, as_printed, T(1) - alpha - as_printed});
  }
};

}  // namespace rayproof::triangle

#include <rayproof/rounding/as_before.hpp>
