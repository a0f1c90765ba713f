#pragma once
#include <rayproof/quadratic/kahan.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::quadratic {

/// Kahan's method for coefficients of any finite size: exponents are balanced first, so that nothing on the
/// way overflows or underflows unless the root itself does.
///
/// With x = 2^k·y, k halfway between the exponents of c and a, the scaled a and c lie within [1/2, 2). A
/// scaled b of more than 2^digits would overflow when squared; there √D = |b| to the last digit.
struct FullRange {
  static constexpr const char* name = "full_range";
  static constexpr const char* title = "Kahan's discriminant on balanced exponents";
  static constexpr Source source{
      "F. Goualard", "The Ins and Outs of Solving Quadratic Equations with Floating-Point Arithmetic", 2023};
  static constexpr Contract contract{
      .verdict = {.measured = 0, .promised = 0, .is_proven = true},
      .residual = {.measured = 3.96, .promised = 8},
      .ulp = {.measured = 3.45, .promised = 4},
      .domain = any_finite,
      .holds = always_claimed | Claims{Claim::verdict, Claim::residual, Claim::ulp, Claim::robust,
                                       Claim::scaled, Claim::reversed, Claim::exact}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Quadratic<T>& q) {
    step<T>("Balance the exponents of a and c",
            "With x = 2^k·y the scaled a and c lie between 1/2 and 2, so that their product cannot overflow "
            "or underflow.");
    const T e_a = exponent(select(q.a == T(0), q.c, q.a));
    const T e_c = exponent(select(q.c == T(0), q.a, q.c));
    const T k = floor(T(0.5) * (e_c - e_a));
    const T e_b = exponent(q.b) + k - e_c;
    const Quadratic<T> balanced{scale_exponent(q.a, T(2) * k - e_c), scale_exponent(q.b, k - e_c),
                                scale_exponent(q.c, -e_c)};

    step<T>("Solve the balanced equation and scale its roots back",
            "The next steps find y by Kahan's method; then x = 2^k·y, which changes only the exponent.");
    const Roots<T> y = Kahan::roots(balanced);
    const T x0 = scale_exponent(y.lo, k);
    const T x1 = scale_exponent(y.hi, k);

    step<T>("Where b outweighs a and c beyond all digits, take -b/a and -c/b",
            "Where 4ac is too small to change b², √D is |b| and the roots are −b / a and −c / b; "
            "where a = 0, only −c / b.");
    const Mask<T> b_rules = q.b != T(0) && (q.a == T(0) || q.c == T(0) || T(digits<T>) < e_b);
    const T small = -q.c / q.b;
    const T large = select(q.a == T(0), small, -q.b / q.a);
    const T positive = T(1) + (q.a - q.a) + (q.b - q.b);  // or NaN where a or b is; with c NaN, b rules no D
    return ascending(select(b_rules, positive, y.discriminant), select(b_rules, large, x0),
                     select(b_rules, small, x1));
  }
};

}  // namespace rayproof::quadratic

#include <rayproof/rounding/as_before.hpp>
