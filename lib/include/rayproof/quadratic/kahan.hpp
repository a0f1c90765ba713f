#pragma once
#include <rayproof/formulas/difference_of_products.hpp>
#include <rayproof/quadratic/citardauq_viete.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::quadratic {

/// The discriminant by Kahan's difference of products with FMA, then the roots that do not cancel.
///
/// The sign of the discriminant is the exact one, so the kind of the roots is never wrong, and the roots are
/// good to a few ulps even for b² near 4ac: as long as nothing over- or underflows.
struct Kahan {
  static constexpr const char* name = "kahan";
  static constexpr const char* title = "Kahan's discriminant with FMA";
  static constexpr Source source{
      "W. Kahan", "On the Cost of Floating-Point Computation Without Extra-Precise Arithmetic", 2004};
  static constexpr Contract contract{
      .verdict = {.measured = 0, .promised = 0, .is_proven = true},
      .residual = {.measured = 3.98, .promised = 8},
      .ulp = {.measured = 3.49, .promised = 4},
      .holds = always_claimed | Claims{Claim::verdict, Claim::residual, Claim::ulp, Claim::robust,
                                       Claim::scaled, Claim::reversed, Claim::bounded, Claim::exact}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Quadratic<T>& q) {
    step<T>("Form the discriminant without losing its digits",
            "A fused multiply-add finds the rounding error of 4a·c, and D is corrected by it: so the sign of "
            "D is exact.");
    const T D = named("D", difference_of_products(q.b, q.b, T(4) * q.a, q.c));
    return CitardauqViete::roots_from(q, D);
  }
};

}  // namespace rayproof::quadratic

#include <rayproof/rounding/as_before.hpp>
