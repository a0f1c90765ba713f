#pragma once
/// \file
/// The roots of one function of one variable over an interval, none of them missed: bisection by interval
/// values, interval Newton steps where the function is monotone.
///
/// Source: R. E. Moore, "Interval Analysis", 1966; applied to ray tracing by D. P. Mitchell, "Robust Ray
/// Intersection with Interval Arithmetic", Graphics Interface 1990.

#include <rayproof/implicit.hpp>
#include <rayproof/implicit/newton.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::implicit {

/// The search. `g` is a callable of any arithmetic; here it runs in Interval<T> and Dual<Interval<T>>.
/// Ranges wait in a queue, so that the widest are looked at first and a budget that ends leaves none of them
/// unexamined while another is cut ever finer.
template <class T, class G>
class Isolation {
 public:
  Isolation(const G& g, std::size_t budget, std::size_t& spent, EnclosedRoots<T>& found)
      : g_(g), budget_(budget), spent_(spent), found_(found) {}

  /// Adds what encloses the roots in `range` to `found`, in no order. `is_rootless(part)` may know in another
  /// way that a part holds none.
  template <class IsRootless>
  void search(const Interval<T>& range, IsRootless&& is_rootless) {
    std::vector<Interval<T>> waiting;
    if (!range.is_empty()) waiting.push_back(range);
    for (std::size_t next = 0; next < waiting.size(); ++next) {
      const Interval<T> part = waiting[next];
      if (spent_ >= budget_) {
        add(part, RootStatus::undecided);
      } else if (!is_rootless(part)) {
        for (const Interval<T>& left : examine(part))
          if (!left.is_empty()) waiting.push_back(left);
      }
    }
  }

 private:
  static constexpr Parts<T> nothing{Interval<T>::empty(), Interval<T>::empty()};

  /// Adds an enclosure; nothing of it is left to examine.
  Parts<T> add(const Interval<T>& range, RootStatus status) {
    found_.push_back({range.lo, range.hi, status});
    return nothing;
  }

  /// Excludes a range, decides it, or gives the parts of it that are left to examine.
  Parts<T> examine(const Interval<T>& range) {
    const Dual<Interval<T>> g = g_(variable(range));
    ++spent_;
    if (!g.value.contains(T(0))) return nothing;
    if (g.value.is_point() && !range.is_point()) return add(range, RootStatus::everywhere);
    const Interval<T> slope = slope_of(g);
    if (slope.contains(T(0)) || !range.is_bounded()) return split(range, slope);
    const auto [left, has_root] = refine_monotone(g_, range, slope, spent_);
    if (left.is_empty()) return nothing;
    return add(left, has_root ? RootStatus::certain : RootStatus::undecided);
  }

  Parts<T> split(const Interval<T>& range, const Interval<T>& slope) {
    const Interval<T> middle = range.middle();
    const Interval<T> at_middle = g_(middle);
    ++spent_;
    if (range.is_bounded()) {
      // The mean value theorem: g(t) = g(m) + g'(somewhere)·(t - m).
      const Interval<T> change = slope * (range - middle);
      if (!(at_middle + change).contains(T(0))) return nothing;
      // Where rounding alone is as large as all that g changes, cutting finer decides nothing.
      if (at_middle.contains(T(0)) && change.width() <= 4 * at_middle.width())
        return add(range, RootStatus::undecided);
    }
    const T cut = at_middle.contains(T(0)) ? beside_the_middle(range, middle.lo) : middle.lo;
    if (!(range.lo < cut && cut < range.hi)) return add(range, RootStatus::undecided);
    return parts_beside(range, cut, cut == middle.lo ? at_middle : g_(Interval<T>(cut)), slope);
  }

  /// A place to cut where g is not 0: a root that lies on a cut would be found twice, half each time.
  T beside_the_middle(const Interval<T>& range, T middle) {
    if (!range.is_bounded()) return middle;
    for (const T fraction : {T(0.125), T(-0.125), T(0.3125)}) {
      const T cut = middle + fraction * (range.hi - range.lo);
      ++spent_;
      if (!g_(Interval<T>(cut)).contains(T(0))) return cut;
    }
    return middle;
  }

  const G& g_;
  std::size_t budget_;
  std::size_t& spent_;
  EnclosedRoots<T>& found_;
};

}  // namespace rayproof::implicit

#include <rayproof/rounding/as_before.hpp>
