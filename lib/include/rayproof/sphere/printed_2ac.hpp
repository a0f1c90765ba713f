#pragma once
#include <rayproof/sphere/textbook.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::sphere {

/// The quadratic formula with the denominator 2ac, **as printed** in the source: wrong unless c = 1.
///
/// The right denominator is 2a (see Textbook).
struct Printed2ac {
  static constexpr const char* name = "printed_2ac";
  static constexpr const char* title = "as printed: denominator 2ac";
  static constexpr Source source = sources::drabek;
  static constexpr Contract contract{
      .standing = Standing::printed,
      .holds = always_claimed,
      .refuted = {{{Claim::robust, "the denominator must be 2a, not 2ac"},
                   {Claim::scaled, "2ac has the wrong dimension: t changes when the scene's unit does"},
                   {Claim::exact, "a division by 2ac is wrong without a rounding, too"}}}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Ray<T>& ray, const Sphere<T>& sphere) {
    const auto [a, half_b, c] = coefficients(ray, sphere);
    const T b = named("b", T(2) * half_b);

    step<T>(steps::discriminant);
    const T D = named("D", b * b - T(4) * a * c);

    step<T>("Divide by 2ac, as printed",
            "The denominator must be 2a: the printed 2ac gives wrong roots unless c = 1.");
    const T s = named("√D", sqrt(D));
    const T t0 = named("t₀", (-b - s) / (T(2) * a * c));
    const T t1 = named("t₁", (-b + s) / (T(2) * a * c));
    return ascending(D, t0, t1);
  }
};

}  // namespace rayproof::sphere

#include <rayproof/rounding/as_before.hpp>
