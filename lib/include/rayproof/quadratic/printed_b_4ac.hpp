#pragma once
#include <rayproof/method/sources.hpp>
#include <rayproof/quadratic/citardauq_viete.hpp>
#include <rayproof/quadratic/textbook.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::quadratic {

/// The branch without cancellation, but only for 'b ≫ 4ac', **as printed** in the source; the condition must
/// be b² ≫ 4ac. 'Much larger' is taken to mean a thousand times.
///
/// Everything in between, where b² ≫ 4ac and b is not, falls to the textbook's formula and its cancellation.
struct PrintedB4ac {
  static constexpr const char* name = "printed_b_4ac";
  static constexpr const char* title = "as printed: the careful branch only for b ≫ 4ac";
  static constexpr Source source = sources::ban;
  static constexpr Contract contract{
      .standing = Standing::printed,
      .holds = always_claimed,
      .refuted = {
          {{Claim::robust, "the condition must be b² ≫ 4ac: b² and 4ac have one unit, b and 4ac not"},
           {Claim::exact, "a = 0 leaves 0/0 to the branch that is left, and no rounding is to blame"}}}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Quadratic<T>& q) {
    step<T>("Ask whether b ≫ 4ac, as printed",
            "Cancellation depends on b² and 4ac, not on b and 4ac as printed; 'much larger' is taken as 1000 "
            "times.");
    const Mask<T> is_far_larger = q.b > T(1000) * named("4ac", T(4) * q.a * q.c);
    const Roots<T> careful = CitardauqViete::roots(q);
    const Roots<T> plain = Textbook::roots(q);
    return {plain.discriminant, select(is_far_larger, careful.lo, plain.lo),
            select(is_far_larger, careful.hi, plain.hi)};
  }
};

}  // namespace rayproof::quadratic

#include <rayproof/rounding/as_before.hpp>
