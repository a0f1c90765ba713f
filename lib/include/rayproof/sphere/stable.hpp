#pragma once
#include <rayproof/sphere/textbook.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::sphere {

/// The textbook's coefficients, but roots that do not cancel: one from the branch where b and √D add up, the
/// other from Viète's t₀t₁ = c/a.
///
/// No root cancels any more, which mends little of a sphere: c and the discriminant have lost digits before,
/// by the rounding of a, b and c. The bound is the textbook's, and far spheres fail as there. At b = 0 the
/// two roots come from different formulas whichever way the ray points, so reversing it need not mirror them
/// to the last bit.
struct Stable {
  static constexpr const char* name = "stable";
  static constexpr const char* title = "stable roots on the textbook's coefficients";
  static constexpr Source source = sources::press;
  static constexpr Contract contract{
      .standing = Standing::naive,
      .verdict = {.measured = 6.49, .promised = 16, .far_power = 1},
      .residual = {.measured = 6.49, .promised = 16, .far_power = 1},
      .hit = sphere_hit_bounds,
      .holds =
          always_claimed | hit_claims |
          Claims{Claim::verdict, Claim::residual, Claim::moved, Claim::scaled, Claim::bounded, Claim::exact},
      .refuted = {
          {{Claim::robust, "stable roots can't mend coefficients whose rounding already lost the sphere"}}}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Ray<T>& ray, const Sphere<T>& sphere) {
    const auto [a, half_b, c] = coefficients(ray, sphere);
    const T b = named("b", -half_b);

    step<T>(steps::quarter_discriminant);
    const T D = named("D", b * b - a * c);

    step<T>(steps::sum_without_cancellation);
    const T q = named("q", b + copysign(sqrt(D), b));

    step<T>(steps::roots_by_viete);
    const T t1 = named("t₁", q / a);
    // A double root is one number; b = D = 0 leaves q = 0, and 0/0 must not be.
    const T t0 = named("t₀", select(D == T(0), t1, c / q));
    return ascending(D, t0, t1);
  }
};

}  // namespace rayproof::sphere

#include <rayproof/rounding/as_before.hpp>
