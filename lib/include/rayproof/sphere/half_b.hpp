#pragma once
#include <rayproof/sphere/textbook.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::sphere {

/// Ray and sphere with b halved: at² + 2bt + c = 0, one multiplication and one rounding fewer than the
/// textbook's.
///
/// Corrects the printed t = -b ± √(b² - c), which holds only for |d| = 1 (see PrintedHalfB). Fails far
/// spheres as the textbook formula does.
struct HalfB {
  static constexpr const char* name = "half_b";
  static constexpr const char* title = "half-b form, any direction length";
  static constexpr Source source{"E. V. Shikin, A. V. Boreskov", "Komp'yuternaya grafika", 1996};
  static constexpr Contract contract{
      .standing = Standing::naive,
      .verdict = {.measured = 8.94, .promised = 16, .far_power = 1},
      .residual = {.measured = 8.94, .promised = 16, .far_power = 1},
      .hit = sphere_hit_bounds,
      .holds = always_claimed | hit_claims |
               Claims{Claim::verdict, Claim::residual, Claim::moved, Claim::scaled, Claim::reversed,
                      Claim::bounded, Claim::exact},
      .refuted = {
          {{Claim::robust, "b² and ac of a far sphere nearly agree, and rounding decides the sign of D"}}}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Ray<T>& ray, const Sphere<T>& sphere) {
    const auto [a, half_b, c] = coefficients(ray, sphere);
    const T b = named("b", half_b);

    step<T>(steps::quarter_discriminant);
    const T D = named("D", b * b - a * c);

    step<T>("Apply the halved quadratic formula",
            "With 2b as the linear coefficient every factor 2 cancels: t = (−b ± √D) / a.");
    const T s = named("√D", sqrt(D));
    const T t0 = named("t₀", (-b - s) / a);
    const T t1 = named("t₁", (-b + s) / a);
    return ascending(D, t0, t1);
  }
};

}  // namespace rayproof::sphere

#include <rayproof/rounding/as_before.hpp>
