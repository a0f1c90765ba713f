#pragma once
#include <rayproof/contract.hpp>
#include <rayproof/narration.hpp>
#include <rayproof/sphere.hpp>

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
  static constexpr int far_power = 1;
  static constexpr Contract contract{
      .standing = Standing::naive,
      .verdict = {.measured = 0, .promised = 16},
      .residual = {.measured = 0, .promised = 16},
      .holds = always_claimed | Claims{Claim::verdict, Claim::residual, Claim::moved, Claim::scaled,
                                       Claim::reversed, Claim::bounded},
      .refuted = {{{Claim::robust, "b² and ac of a far sphere agree in all the digits that are kept"}}}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Ray<T>& ray, const Sphere<T>& sphere) {
    step<T>("Put the ray into the sphere's equation");
    const vec3<T> f = named("f", ray.origin - sphere.center);
    const vec3<T> d = ray.direction;
    const T a = named("a", dot(d, d));
    const T b = named("b", dot(d, f));
    const T c = named("c", dot(f, f) - sphere.radius * sphere.radius);

    step<T>("Form a quarter of the discriminant");
    const T D = named("D", b * b - a * c);

    step<T>("Apply the halved quadratic formula");
    const T s = named("√D", sqrt(D));
    const T t0 = named("t₀", (-b - s) / a);
    const T t1 = named("t₁", (-b + s) / a);
    return ascending(D, t0, t1);
  }
};

}  // namespace rayproof::sphere
