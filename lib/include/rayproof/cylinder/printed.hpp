#pragma once
#include <rayproof/cylinder/textbook.hpp>
#include <rayproof/method/method.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::cylinder {

/// The side by the quadratic formula with t in [0, 1] and no caps, **as printed** in the source.
///
/// A t in [0, 1] is a segment's, though the text calls it a ray, and the ends of a closed cylinder are not
/// named. Textbook is the mended form.
struct Printed {
  static constexpr const char* name = "printed";
  static constexpr const char* title = "as printed: t in [0, 1], no caps";
  static constexpr Source source = sources::maric;
  static constexpr Contract contract{
      .standing = Standing::printed,
      .holds = always_claimed,
      .refuted = {{{Claim::robust, "what lies beyond the direction's tip is dropped, and so are the caps"},
                   {Claim::scaled, "a direction twice as long halves t and brings hits into [0, 1]"},
                   {Claim::exact, "caps are missing and t ends at 1 where nothing is rounded"}}}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Ray<T>& ray, const Cylinder<T>& cylinder) {
    const auto [a, b, c] = side_equation(ray, cylinder);
    const Roots<T> side = quadratic_formula(a, b, c, "s₀", "s₁");
    const Roots<T> all = open_hits(side, between_heights(ray, cylinder));

    step<T>("Keep what lies on the segment, as printed",
            "Only t in [0, 1] is kept, so hits beyond the tip of the direction are lost.");
    return kept<T>(all, T(0) <= all.lo && all.lo <= T(1), T(0) <= all.hi && all.hi <= T(1));
  }
};

}  // namespace rayproof::cylinder

#include <rayproof/rounding/as_before.hpp>
