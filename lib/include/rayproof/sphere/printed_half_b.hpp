#pragma once
#include <rayproof/method/method.hpp>
#include <rayproof/sphere.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::sphere {

/// t = -b ± √(b² - c), **as printed** in the source, which does not say that it needs |d| = 1.
///
/// Refuted by a direction of another length. HalfB is the mended form.
struct PrintedHalfB {
  static constexpr const char* name = "printed_half_b";
  static constexpr const char* title = "as printed: half-b form without |d| = 1";
  static constexpr Source source = sources::lecture_001;
  static constexpr Contract contract{
      .standing = Standing::printed,
      .holds = always_claimed,
      .refuted = {{{Claim::robust, "holds only for a direction of length 1"},
                   {Claim::scaled, "a direction twice as long must halve t"},
                   {Claim::exact, "|d| = 1 is assumed, and no rounding is to blame"}}}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Ray<T>& ray, const Sphere<T>& sphere) {
    step<T>("Put the ray into the sphere's equation, taking |d| = 1 for granted",
            "|o + t·d − C|² = r² is t² + 2b·t + c = 0 only where a = |d|² is 1.");
    const vec3<T> f = named("f", ray.origin - sphere.center);
    const vec3<T> d = ray.direction;
    const T b = named("b", dot(d, f));
    const T c = named("c", dot(f, f) - sphere.radius * sphere.radius);

    step<T>("Form the discriminant", "b² − c is a quarter of the discriminant only where a = 1.");
    const T D = named("D", b * b - c);

    step<T>("Apply the formula as printed", "The division by a = |d|² is missing.");
    const T s = named("√D", sqrt(D));
    const T t0 = named("t₀", -b - s);
    const T t1 = named("t₁", -b + s);
    return ascending(D, t0, t1);
  }
};

}  // namespace rayproof::sphere

#include <rayproof/rounding/as_before.hpp>
