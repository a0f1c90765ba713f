#pragma once
#include <rayproof/formulas/quadratic_formula.hpp>
#include <rayproof/method/method.hpp>
#include <rayproof/quadratic.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::quadratic {

/// x = 2c / (-b ∓ √(b² - 4ac)), the quadratic formula upside down, for a near 0.
///
/// Keeps one root when a vanishes; its other branch cancels exactly as the textbook formula's does, down to a
/// 0 that has lost its sign, so that reversing x need not mirror the roots.
struct Citardauq {
  static constexpr const char* name = "citardauq";
  static constexpr const char* title = "the quadratic formula upside down";
  static constexpr Source source = sources::ban;
  static constexpr Contract contract{
      .standing = Standing::naive,
      .verdict = {.promised = 4},
      .holds = always_claimed | Claims{Claim::scaled, Claim::bounded},
      .refuted = {{{Claim::robust, "for b² >> 4ac its other branch divides by what cancellation left"},
                   {Claim::verdict, "b = c = 0 leaves 0/0 for the root 0"},
                   {Claim::exact, "b = c = 0 leaves 0/0, and no rounding is to blame"}}}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Quadratic<T>& q) {
    step<T>(steps::discriminant);
    const T D = named("D", q.b * q.b - T(4) * q.a * q.c);

    step<T>(
        "Apply the formula upside down",
        "2c / (−b ∓ √D) gives the same two roots without a division by a, so one root remains where a = 0.");
    const T s = named("√D", sqrt(D));
    const T x1 = named("x₁", T(2) * q.c / (-q.b - s));
    const T x0 = named("x₀", T(2) * q.c / (-q.b + s));
    return ascending(D, x1, x0);
  }
};

}  // namespace rayproof::quadratic

#include <rayproof/rounding/as_before.hpp>
