#pragma once
/// \file
/// The last pass over what a search has found: enclosures that touch become one, and an undecided one is
/// looked at from a little further away, where a root on a cut lies in the middle.

#include <algorithm>
#include <rayproof/implicit/newton.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::implicit {

/// Sorts, clips to `range`, unites and refines. `g` is the function of t.
template <class T, class G>
class Refinement {
 public:
  Refinement(const G& g, const Interval<T>& range, std::size_t budget, std::size_t& spent)
      : g_(g), range_(range), budget_(budget), spent_(spent) {}

  [[nodiscard]] EnclosedRoots<T> of(EnclosedRoots<T> found) {
    std::erase_if(found, [&](RootEnclosure<T>& one) { return !clip(one); });
    std::sort(found.begin(), found.end(),
              [](const auto& a, const auto& b) { return a.lo < b.lo || (a.lo == b.lo && a.hi < b.hi); });
    EnclosedRoots<T> united = unite(found);
    for (std::size_t i = 0; i < united.size(); ++i) refine(united, i);
    std::erase_if(united, [](const RootEnclosure<T>& one) { return one.lo != one.lo; });
    return united;
  }

 private:
  static Interval<T> range_of(const RootEnclosure<T>& one) { return Interval<T>::between(one.lo, one.hi); }

  /// Cuts off what lies outside of the range, and with it the certainty; false where nothing is left.
  bool clip(RootEnclosure<T>& one) const {
    const Interval<T> left = intersection(range_of(one), range_);
    const bool was_cut = left.lo != one.lo || left.hi != one.hi;
    if (was_cut && one.status == RootStatus::certain) one.status = RootStatus::undecided;
    one.lo = left.lo;
    one.hi = left.hi;
    return !left.is_empty();
  }

  /// Two that overlap, or touch where one of them is undecided, may share a root.
  [[nodiscard]] bool are_apart(const RootEnclosure<T>& a, const RootEnclosure<T>& b) const {
    return a.hi < b.lo || (a.hi == b.lo && a.status == RootStatus::certain &&
                           b.status == RootStatus::certain && !g_(Interval<T>(b.lo)).contains(T(0)));
  }

  [[nodiscard]] EnclosedRoots<T> unite(const EnclosedRoots<T>& found) const {
    EnclosedRoots<T> united;
    for (const RootEnclosure<T>& one : found) {
      if (united.empty() || are_apart(united.back(), one)) {
        united.push_back(one);
        continue;
      }
      RootEnclosure<T>& last = united.back();
      // All roots, or the same point found from both sides. (Equal ranges are not enough: beyond the greatest
      // number there is one range for all.)
      const bool are_alike =
          last.status == one.status && (one.status == RootStatus::everywhere || last.lo == one.hi);
      if (!are_alike) last.status = RootStatus::undecided;
      last.hi = max(last.hi, one.hi);
    }
    return united;
  }

  /// Tries to tighten what is certain and to decide what is not; takes out (as NaN) what holds no root.
  void refine(EnclosedRoots<T>& all, std::size_t i) {
    RootEnclosure<T>& one = all[i];
    if (one.status == RootStatus::everywhere || spent_ >= budget_) return;
    Interval<T> wider = range_of(one);
    if (!g_(wider).contains(T(0))) {
      one.lo = not_a_number<T>;
      return;
    }
    if (!wider.is_bounded()) return;
    if (one.status == RootStatus::undecided) wider = widened(all, i);
    const Interval<T> slope = slope_of(g_(variable(wider)));
    spent_ += 2;
    if (slope.contains(T(0))) return;
    const Contracted<T> found = one.status == RootStatus::undecided
                                    ? refine_monotone(g_, wider, slope, spent_)
                                    : contract(g_, wider, slope, spent_);
    const Interval<T> left = found.has_root ? found.range : intersection(found.range, range_of(one));
    one.lo = left.lo;
    one.hi = left.hi;
    if (found.has_root) one.status = RootStatus::certain;
  }

  /// As wide again to either side, but not into a neighbour nor out of the range.
  Interval<T> widened(const EnclosedRoots<T>& all, std::size_t i) const {
    const RootEnclosure<T>& one = all[i];
    const T size = max(abs(one.lo), abs(one.hi));
    const T more = max(one.hi - one.lo, 8 * std::numeric_limits<T>::epsilon() * size);
    T lo = max(one.lo - more, range_.lo);
    T hi = min(one.hi + more, range_.hi);
    if (i > 0) lo = max(lo, min(one.lo, all[i - 1].hi));
    if (i + 1 < all.size()) hi = min(hi, max(one.hi, all[i + 1].lo));
    return Interval<T>::between(lo, hi);
  }

  const G& g_;
  Interval<T> range_;
  std::size_t budget_;
  std::size_t& spent_;
};

}  // namespace rayproof::implicit

#include <rayproof/rounding/as_before.hpp>
