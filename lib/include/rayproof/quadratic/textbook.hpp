#pragma once
#include <rayproof/formulas/quadratic_formula.hpp>
#include <rayproof/method/method.hpp>
#include <rayproof/quadratic.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::quadratic {

/// x = (-b ± √(b² - 4ac)) / 2a.
///
/// Where b² >> 4ac, √D is nearly |b| and the smaller root is what little their difference leaves.
struct Textbook {
  static constexpr const char* name = "textbook";
  static constexpr const char* title = "the quadratic formula";
  static constexpr Source source = sources::ban;
  static constexpr Contract contract{
      .standing = Standing::naive,
      .verdict = {.promised = 4},
      .holds = always_claimed | Claims{Claim::scaled, Claim::reversed, Claim::bounded},
      .refuted = {{{Claim::robust, "for b² >> 4ac, -b and √D cancel in the smaller root"},
                   {Claim::verdict, "a = 0 leaves 0/0, though a linear equation has its root"},
                   {Claim::exact, "0/0 is no root of a linear equation, and no rounding is to blame"}}}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Quadratic<T>& q) {
    const auto [D, x0, x1] = quadratic_formula(q.a, q.b, q.c, "x₀", "x₁");
    return ascending(D, x0, x1);
  }
};

}  // namespace rayproof::quadratic

#include <rayproof/rounding/as_before.hpp>
