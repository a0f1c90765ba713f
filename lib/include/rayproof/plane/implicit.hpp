#pragma once
#include <rayproof/method/method.hpp>
#include <rayproof/plane/forms.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::plane {

/// The t at which the plane's equation is 0, from its value at the ray's origin and what each unit of t adds;
/// none where it adds 0.
template <class T>
[[nodiscard]] constexpr FlatHit<T> solved_for_t(const T& at_origin, const T& along) {
  step<T>("Solve it for t",
          "t is minus the value at the ray's origin over what each unit of t adds; where that is 0, the ray "
          "is parallel to the plane or in it, and there is no t.");
  return flat_hit(along != T(0), named("t", -at_origin / along), T(0), T(0));
}

/// t = -(n·o + D) / (n·d), the ray put into the plane's equation.
///
/// A ray with n·d = 0 is parallel to the plane or runs inside it: a miss.
struct ByEquation {
  static constexpr const char* name = "implicit";
  static constexpr const char* title = "the ray in the plane's equation";
  static constexpr Source source = sources::ban;
  static constexpr Contract contract{
      .verdict = {.measured = 2.84, .promised = plane_robust_bound, .is_proven = true},
      .residual = {.measured = 3.92, .promised = plane_robust_bound, .is_proven = true},
      .hit = {plane_hit_bounds.point, plane_hit_bounds.normal},
      .holds = robust_claims | hit_claims | Claims{Claim::residual, Claim::bounded}};

  template <class T>
  [[nodiscard]] static constexpr FlatHit<T> roots(const Ray<T>& ray, const Plane<T>& plane) {
    const auto [n, D] = as_implicit(plane);

    step<T>("Put the ray into the plane's equation",
            "p(t) is in the plane where n·p(t) + D = 0. n·o + D is the value at the ray's origin. Each unit "
            "of t adds n·d to n·p(t) + D.");
    const T at_origin = named("n·o + D", dot(n, ray.origin) + D);
    const T along = named("n·d", dot(n, ray.direction));
    return solved_for_t(at_origin, along);
  }
};

}  // namespace rayproof::plane

#include <rayproof/rounding/as_before.hpp>
