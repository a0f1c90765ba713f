#pragma once
/// \file
/// Interval Newton steps for one function of one variable.
///
/// Source: R. E. Moore, "Interval Analysis", 1966; the step by a slope that contains 0: E. R. Hansen,
/// S. Sengupta, "Bounding Solutions of Systems of Equations Using Interval Analysis", 1981.

#include <array>
#include <rayproof/arithmetics/dual.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::implicit {

/// What is left of a range: where roots may be, and whether there is one for certain.
template <class T>
struct Contracted {
  Interval<T> range;
  bool has_root = false;
};

/// The derivative over a range, as g gives it with the value; everything where it has none.
template <class T>
[[nodiscard]] Interval<T> slope_of(const Dual<Interval<T>>& over_range) {
  return over_range.slope.is_empty() ? Interval<T>::whole() : over_range.slope;
}

/// Shrinks a range on which g is monotone to the root it holds, if any, quadratically:
/// X ← X ∩ (m - g(m)/g'(X)). A step that ends inside the range proves a root there.
template <class T, class G>
[[nodiscard]] Contracted<T> contract(const G& g, Interval<T> range, Interval<T> slope, std::size_t& spent) {
  bool has_root = false;
  for (int step = 0; step < 64 && range.is_bounded() && !range.is_point(); ++step) {
    const Interval<T> middle = range.middle();
    const Interval<T> newton = middle - g(middle) / slope;
    const Interval<T> left = intersection(range, newton);
    spent += 2;
    if (left.is_empty()) return {left, false};
    has_root = has_root || (range.lo < newton.lo && newton.hi < range.hi);
    const bool is_slow = !(left.width() < T(0.75) * range.width());
    range = left;
    if (is_slow) break;
    slope = intersection(slope, slope_of(g(variable(range))));
    if (slope.is_empty()) break;
  }
  // No relative width is small at 0, the root of every ray that starts on the surface.
  if (range.lo < 0 && range.hi > 0 && g(Interval<T>(0)).sign_or_two() == 0) return {0, true};
  return {range, has_root};
}

/// Decides a range on which g is monotone, `slope` not containing 0: no root (an empty range), one root for
/// certain, or not known. The root may be an end of the range, if g is exactly 0 there.
template <class T, class G>
[[nodiscard]] Contracted<T> refine_monotone(const G& g, const Interval<T>& range, const Interval<T>& slope,
                                            std::size_t& spent) {
  const int at_lo = g(Interval<T>(range.lo)).sign_or_two();
  const int at_hi = g(Interval<T>(range.hi)).sign_or_two();
  spent += 2;
  if (at_lo == 0) return {range.lo, true};
  if (at_hi == 0) return {range.hi, true};
  const bool is_sure = at_lo != 2 && at_hi != 2;
  if (is_sure && at_lo == at_hi) return {Interval<T>::empty(), false};
  Contracted<T> found = contract(g, range, slope, spent);
  found.has_root = found.has_root || (is_sure && !found.range.is_empty());
  return found;
}

/// What the extended Newton step leaves of a range whose slope contains 0: a part to the left of its middle
/// and one to the right, either perhaps empty.
template <class T>
using Parts = std::array<Interval<T>, 2>;

/// With g(m) not 0, a gap about the middle holds no root.
template <class T>
[[nodiscard]] Parts<T> parts_beside(const Interval<T>& range, T middle, const Interval<T>& at_middle,
                                    const Interval<T>& slope) {
  const auto left = Interval<T>::between(range.lo, middle);
  const auto right = Interval<T>::between(middle, range.hi);
  const int side = at_middle.sign_or_two();
  if (side != 1 && side != -1) return {left, right};
  const auto falling = Interval<T>::between(slope.lo, min(slope.hi, T(0)));
  const auto rising = Interval<T>::between(max(slope.lo, T(0)), slope.hi);
  const auto reached = [&](const Interval<T>& half) { return Interval<T>(middle) - at_middle / half; };
  // To the right of the middle g comes down to 0 by a falling slope only, or up by a rising one.
  return {intersection(left, reached(side > 0 ? rising : falling)),
          intersection(right, reached(side > 0 ? falling : rising))};
}

}  // namespace rayproof::implicit

#include <rayproof/rounding/as_before.hpp>
