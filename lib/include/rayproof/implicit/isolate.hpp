#pragma once
/// \file
/// The roots of one function of one variable over an interval, none of them missed: bisection by interval
/// values, interval Newton steps where the function is monotone.
///
/// Source: R. E. Moore, "Interval Analysis", 1966; applied to ray tracing by D. P. Mitchell, "Robust Ray
/// Intersection with Interval Arithmetic", Graphics Interface 1990.

#include <array>
#include <rayproof/implicit.hpp>
#include <rayproof/implicit/newton.hpp>

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
    std::vector<Interval<T>> waiting{range};
    for (std::size_t next = 0; next < waiting.size(); ++next) {
      if (spent_ >= budget_) {
        add(waiting[next], RootStatus::undecided);
      } else if (!is_rootless(waiting[next])) {
        const Parts<T> parts = examine(Interval<T>(waiting[next]));
        if (!parts.left.is_empty()) waiting.push_back(parts.left);
        if (!parts.right.is_empty()) waiting.push_back(parts.right);
      }
    }
  }
  void search(const Interval<T>& range) {
    search(range, [](const Interval<T>&) { return false; });
  }

 private:
  static Parts<T> nothing() { return {Interval<T>::empty(), Interval<T>::empty()}; }

  void add(const Interval<T>& range, RootStatus status) { found_.push_back({range.lo, range.hi, status}); }

  /// Excludes a range, decides it, or gives the parts of it that are left to examine.
  Parts<T> examine(const Interval<T>& range) {
    const Dual<Interval<T>> g = g_(variable(range));
    ++spent_;
    if (!g.value.contains(T(0))) return nothing();
    if (g.value.is_point() && !range.is_point()) {
      add(range, RootStatus::everywhere);
      return nothing();
    }
    const Interval<T> slope = slope_of(g);
    if (!slope.contains(T(0)) && range.is_bounded()) {
      const Contracted<T> left = refine_monotone(g_, range, slope, spent_);
      if (!left.range.is_empty())
        add(left.range, left.has_root ? RootStatus::certain : RootStatus::undecided);
      return nothing();
    }
    return split(range, slope);
  }

  Parts<T> split(const Interval<T>& range, const Interval<T>& slope) {
    const Interval<T> middle = range.middle();
    const Interval<T> at_middle = g_(middle);
    ++spent_;
    if (range.is_bounded()) {
      // The mean value theorem: g(t) = g(m) + g'(somewhere)·(t - m).
      const Interval<T> change = slope * (range - middle);
      if (!(at_middle + change).contains(T(0))) return nothing();
      // Where rounding alone is as large as all that g changes, cutting finer decides nothing.
      if (at_middle.contains(T(0)) && change.width() <= 4 * at_middle.width()) {
        add(range, RootStatus::undecided);
        return nothing();
      }
    }
    const T cut = at_middle.contains(T(0)) ? beside_the_middle(range, middle.lo) : middle.lo;
    if (!(range.lo < cut && cut < range.hi)) {
      add(range, RootStatus::undecided);
      return nothing();
    }
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
