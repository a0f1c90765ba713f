#pragma once
#include <rayproof/quadratic/kahan.hpp>

namespace rayproof::quadratic {

/// Kahan's method for coefficients of any finite size: exponents are balanced first, so that nothing on the way
/// overflows or underflows unless the root itself does.
///
/// With x = 2^k·y, k halfway between the exponents of c and a, the scaled a and c lie within [1, 4); a scaled b whose
/// square would overflow is so large that √D = |b| to the last digit.
struct FullRange {
  static constexpr const char* name = "full_range";
  static constexpr const char* title = "Kahan's discriminant on balanced exponents";
  static constexpr Source source{"F. Goualard", "The Ins and Outs of Solving Quadratic Equations with Floating-Point Arithmetic",
                                 2023};
  static constexpr Contract contract{
      .verdict = {.measured = 0, .promised = 0},
      .residual = {.measured = 0, .promised = 8},
      .ulp = {.measured = 0, .promised = 4},
      .domain = any_finite,
      .holds = always_claimed | Claims{Claim::verdict, Claim::residual, Claim::ulp, Claim::robust, Claim::scaled,
                                       Claim::reversed}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Quadratic<T>& q) {
    step<T>("Balance the exponents of a and c");
    // TODO(core)
    return Kahan::roots(q);
  }
};

}  // namespace rayproof::quadratic
