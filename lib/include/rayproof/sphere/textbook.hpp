#pragma once
#include <rayproof/formulas/quadratic_formula.hpp>
#include <rayproof/method/method.hpp>
#include <rayproof/sphere.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::sphere {

/// A ray put into a sphere's equation: a·t² + 2·half_b·t + c = 0 with a = d·d, half_b = d·f, c = f·f - r² and
/// f = origin - center. In floats each is good to a few ε of its largest term, which is why formulas that
/// begin here lose far spheres.
template <class T>
struct Coefficients {
  T a;
  T half_b;
  T c;
};

template <class T>
[[nodiscard]] constexpr Coefficients<T> coefficients(const Ray<T>& ray, const Sphere<T>& sphere) {
  step<T>("Put the ray into the sphere's equation", "|o + t·d − C|² = r² is a quadratic equation in t.");
  const vec3<T> f = named("f", ray.origin - sphere.center);
  const vec3<T> d = ray.direction;
  return {named("a", dot(d, d)), dot(d, f), named("c", dot(f, f) - sphere.radius * sphere.radius)};
}

/// Ray and sphere as every lecture has it: at² + bt + c = 0 by the quadratic formula.
///
/// Right in real numbers and in scenes of one size. In floats the rounding of b² and 4ac, not the geometry,
/// decides whether a small far sphere is hit: the error grows with (S/radius)², which is what far_power = 1
/// says.
struct Textbook {
  static constexpr const char* name = "textbook";
  static constexpr const char* title = "quadratic formula in a, b, c";
  static constexpr Source source = sources::ban;
  static constexpr Contract contract{
      .standing = Standing::naive,
      .verdict = {.measured = 10.6, .promised = 16, .far_power = 1},
      .residual = {.measured = 10.6, .promised = 16, .far_power = 1},
      .hit = sphere_hit_bounds,
      .holds = always_claimed | hit_claims |
               Claims{Claim::verdict, Claim::residual, Claim::moved, Claim::scaled, Claim::reversed,
                      Claim::bounded, Claim::exact},
      .refuted = {
          {{Claim::robust, "b² and 4ac of a far sphere nearly agree, and rounding decides the sign of D"}}}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Ray<T>& ray, const Sphere<T>& sphere) {
    const auto [a, half_b, c] = coefficients(ray, sphere);
    const T b = named("b", T(2) * half_b);
    return quadratic_formula(a, b, c);
  }
};

}  // namespace rayproof::sphere

#include <rayproof/rounding/as_before.hpp>
