#pragma once
#include <rayproof/method/contract.hpp>
#include <rayproof/method/sources.hpp>
#include <rayproof/plane/cramer.hpp>
#include <rayproof/plane/forms.hpp>

namespace rayproof::plane {

/// point + a·u + b·v = o + t·d⃗, solved by Cramer's rule; the answer's u and v are a and b where the plane is
/// given in the parametric form, else 0.
///
/// A ray whose direction u and v span is parallel to the plane or runs inside it: a miss.
struct ByParameters {
  static constexpr const char* name = "parametric";
  static constexpr const char* title = "a system of three equations by Cramer's rule";
  static constexpr Source source = sources::ban;
  static constexpr int far_power = 0;
  static constexpr Contract contract{
      .verdict = {.measured = 1.68, .promised = plane_robust_bound},
      .residual = {.measured = 1.79, .promised = plane_robust_bound},
      .holds = always_claimed | Claims{Claim::verdict, Claim::residual, Claim::robust, Claim::moved,
                                       Claim::scaled, Claim::reversed, Claim::bounded}};

  template <class T>
  [[nodiscard]] static constexpr FlatHit<T> roots(const Ray<T>& ray, const Plane<T>& plane) {
    const auto [point, u, v] = as_parametric(plane);
    const auto [D, t, a, b] = meet_by_cramer(ray, point, u, v);
    const bool has_parameters = plane.form == PlaneForm::parametric;
    return flat_hit(D != T(0), t, has_parameters ? a : T(0), has_parameters ? b : T(0));
  }
};

}  // namespace rayproof::plane
