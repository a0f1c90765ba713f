#pragma once
#include <rayproof/formulas/quadratic_formula.hpp>
#include <rayproof/method/method.hpp>
#include <rayproof/quadratic.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::quadratic {

/// q = -(b + sgn(b)√D)/2, x = q/a and c/q: each root from the branch in which nothing cancels.
///
/// Backward stable: every root solves an equation whose coefficients differ by a few ε. Where b² is near 4ac
/// the roots themselves are as uncertain as that makes them; Kahan's discriminant cures it.
struct CitardauqViete {
  static constexpr const char* name = "citardauq_viete";
  static constexpr const char* title = "the branch that does not cancel, then Viète";
  static constexpr Source source = sources::press;
  static constexpr Contract contract{
      .verdict = {.measured = 0.984, .promised = 4},
      .residual = {.measured = 3.96, .promised = 8},
      .holds = always_claimed | Claims{Claim::verdict, Claim::residual, Claim::robust, Claim::scaled,
                                       Claim::reversed, Claim::bounded, Claim::exact}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Quadratic<T>& q) {
    step<T>(steps::discriminant);
    const T D = named("D", q.b * q.b - T(4) * q.a * q.c);
    return roots_from(q, D);
  }

  /// The two roots once the discriminant is known, however it was formed.
  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots_from(const Quadratic<T>& q, const T& D) {
    step<T>(steps::sum_without_cancellation);
    const T w = named("q", T(-0.5) * (q.b + copysign(sqrt(D), q.b)));

    step<T>(steps::roots_by_viete);
    // A double root is one number; b = D = 0 leaves w = 0, and 0/0 must not be.
    const T x0 = named("q/a", w / q.a);
    const T x1 = named("c/q", select(D == T(0), x0, q.c / w));
    return ascending(D, x0, x1);
  }
};

}  // namespace rayproof::quadratic

#include <rayproof/rounding/as_before.hpp>
