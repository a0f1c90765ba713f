#pragma once
#include <rayproof/formulas/quadratic_formula.hpp>
#include <rayproof/method/contract.hpp>
#include <rayproof/method/sources.hpp>
#include <rayproof/sphere/coefficients.hpp>

namespace rayproof::sphere {

/// Ray and sphere as every lecture has it: at² + bt + c = 0 by the quadratic formula.
///
/// Right in real numbers and in scenes of one size. In floats the rounding of b² and 4ac, not the geometry,
/// decides whether a small far sphere is hit: the error grows with (S/radius)², which is what far_power = 1
/// says.
struct Textbook {
  static constexpr const char* name = "textbook";
  static constexpr const char* title = "quadratic formula in a, b, c";
  static constexpr Source source = sources::ban;
  static constexpr int far_power = 1;
  static constexpr Contract contract{
      .standing = Standing::naive,
      .verdict = {.measured = 3.92, .promised = 16},
      .residual = {.measured = 4.08, .promised = 16},
      .holds = always_claimed | Claims{Claim::verdict, Claim::residual, Claim::moved, Claim::scaled,
                                       Claim::reversed, Claim::bounded},
      .refuted = {{{Claim::robust, "b² and 4ac of a far sphere agree in all the digits that are kept"}}}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Ray<T>& ray, const Sphere<T>& sphere) {
    const auto [a, half_b, c] = coefficients(ray, sphere);
    const T b = named("b", T(2) * half_b);
    return quadratic_formula(a, b, c);
  }
};

}  // namespace rayproof::sphere
