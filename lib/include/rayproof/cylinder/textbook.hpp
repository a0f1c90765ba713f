#pragma once
#include <rayproof/cylinder/side.hpp>
#include <rayproof/formulas/quadratic_formula.hpp>
#include <rayproof/method/method.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::cylinder {

/// A ray put into the equation of the side: a·t² + b·t + c = 0 in the plane where that is the unit circle.
template <class T>
struct SideEquation {
  T a, b, c;
};

template <class T>
[[nodiscard]] constexpr SideEquation<T> side_equation(const Ray<T>& ray, const Cylinder<T>& cylinder) {
  const auto [fx, fy, dx, dy] = scaled_to_circle(ray, cylinder);
  step<T>("Put the ray into the circle's equation",
          "(f.x + t·d.x)² + (f.y + t·d.y)² = 1 is a quadratic equation in t.");
  return {named("a", dx * dx + dy * dy), named("b", T(2) * (dx * fx + dy * fy)),
          named("c", fx * fx + fy * fy - T(1))};
}

/// The side by the quadratic formula in x²/rx² + y²/ry² = 1, then the heights.
///
/// A far cylinder is lost as a far sphere is: b² and 4ac nearly agree, and rounding decides the sign of D.
struct Textbook {
  static constexpr const char* name = "textbook";
  static constexpr const char* title = "quadratic formula for the side, then the heights";
  static constexpr Source source = sources::maric;
  static constexpr Contract contract{
      .standing = Standing::naive,
      .verdict = {.measured = 4.11, .promised = 16, .far_power = 1},
      .residual = {.measured = 2.55, .promised = 16, .far_power = 1},
      .hit = {.point = cylinder_hit_bounds.point},  // its hits may lie where the side has any normal
      .domain = {.reach_float = 12, .reach_double = 110, .every_number = true},
      .holds = always_claimed | Claims{Claim::point, Claim::verdict, Claim::residual, Claim::moved,
                                       Claim::scaled, Claim::reversed, Claim::bounded, Claim::exact},
      .refuted = {{{Claim::robust,
                    "b² and 4ac of a far cylinder nearly agree, and rounding decides the sign of D"}}}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Ray<T>& ray, const Cylinder<T>& cylinder) {
    const auto [a, b, c] = side_equation(ray, cylinder);
    return hits<T>(ray, cylinder, quadratic_formula(a, b, c, "s₀", "s₁"), c);
  }
};

}  // namespace rayproof::cylinder

#include <rayproof/rounding/as_before.hpp>
