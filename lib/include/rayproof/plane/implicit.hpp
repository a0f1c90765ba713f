#pragma once
#include <rayproof/method/contract.hpp>
#include <rayproof/method/sources.hpp>
#include <rayproof/plane/forms.hpp>

namespace rayproof::plane {

/// t = -(n·o + d) / (n·d⃗), the ray put into the plane's equation.
///
/// A ray with n·d⃗ = 0 is parallel to the plane or runs inside it: a miss.
struct ByEquation {
  static constexpr const char* name = "implicit";
  static constexpr const char* title = "the ray in the plane's equation";
  static constexpr Source source = sources::ban;
  static constexpr int far_power = 0;
  static constexpr Contract contract{
      .verdict = {.measured = 1.68, .promised = plane_robust_bound},
      .residual = {.measured = 1.79, .promised = plane_robust_bound},
      .holds = always_claimed | Claims{Claim::verdict, Claim::residual, Claim::robust, Claim::moved,
                                       Claim::scaled, Claim::reversed, Claim::bounded}};

  template <class T>
  [[nodiscard]] static constexpr FlatHit<T> roots(const Ray<T>& ray, const Plane<T>& plane) {
    const auto [n, d] = as_implicit(plane);

    step<T>("Put the ray into the plane's equation",
            "n·o + d is the value of the equation at the ray's origin; each unit of t adds n·d⃗ to it.");
    const T at_origin = named("n·o + d", dot(n, ray.origin) + d);
    const T along = named("n·d⃗", dot(n, ray.direction));

    step<T>(steps::solve_for_t);
    return flat_hit(along != T(0), named("t", -at_origin / along), T(0), T(0));
  }
};

}  // namespace rayproof::plane
