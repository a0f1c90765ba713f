#pragma once
/// \file
/// All hits of a ray with a surface f(x, y, z) = 0, none of them missed.

#include <rayproof/formulas/searchable.hpp>
#include <rayproof/implicit/along_ray.hpp>
#include <rayproof/implicit/isolate.hpp>
#include <rayproof/implicit/refine.hpp>

namespace rayproof::implicit {

/// What a search came to, and how many evaluations of f it took.
template <class T>
struct Search {
  EnclosedRoots<T> roots;
  std::size_t evaluations = 0;
};

/// Every t of the ray's interval with f(p(t)) = 0, enclosed in ascending order.
///
/// Contract, for every finite ray and any f over the operations of Interval<T>; what of it can be counted is
/// `search_contract`:
/// - no root is missed: a t in [t_min, t_max] outside of all enclosures is no root of the exact function;
/// - a `certain` enclosure lies inside [t_min, t_max] and holds exactly one root, at which f changes its
/// sign;
/// - what cannot be separated is one `undecided` enclosure: tangents, near tangents within rounding, roots
///   within rounding of an end of the interval, and whatever is left when the budget is spent;
/// - the search begins no range after `budget` evaluations of f, the refinement of what it found none after
///   twice as many: `search_contract.overrun` is what the last range may take beyond that;
/// - a zero direction, an infinite or NaN number in the ray, and a NaN coefficient have no root. (A zero
///   direction is a miss even on the surface, as for every shape of this library.)
///
/// An infinite t_min or t_max: a polynomial in homogeneous form is searched in s = 1/t beyond some t, where
/// the ends of the line are the one number s = 0; there a root that is at infinity *exactly* is left out, one
/// that is so but for rounding gives an undecided enclosure with an infinite end. Of any other f the
/// enclosure of the far end is undecided unless its interval values exclude 0.
///
/// Source: R. E. Moore, "Interval Analysis", 1966; D. P. Mitchell, "Robust Ray Intersection with Interval
/// Arithmetic", 1990; E. R. Hansen, S. Sengupta, "Bounding Solutions of Systems of Equations Using Interval
/// Analysis", 1981.
template <class Surface, std::floating_point T>
[[nodiscard]] Search<T> search(const Ray<T>& ray, const Surface& f, std::size_t budget = default_budget) {
  Search<T> result;
  if (!is_searchable(ray)) return result;
  const AlongRay<Surface, T> along{f, ray};
  const auto range = Interval<T>::between(ray.t_min, ray.t_max);
  EnclosedRoots<T> found;
  if constexpr (Homogeneous<Surface, Interval<T>>) {
    const NearInfinity<Surface, T> far{f, ray};
    const T turn = turning_point(ray);
    EnclosedRoots<T> inverse;
    const auto beyond = [&](const Interval<T>& side) {
      const Interval<T> part = intersection(range, side);
      if (part.is_empty()) return;
      Isolation(far, budget, result.evaluations, inverse)
          .search(Interval<T>(1) / part, [&](const Interval<T>& s) {
            ++result.evaluations;  // a ray along a cylinder: no root, but a double one at infinity
            return !along(Interval<T>(1) / s).contains(T(0));
          });
    };
    const Interval<T> near = intersection(range, Interval<T>::between(-turn, turn));
    if (!near.is_empty()) Isolation(along, budget, result.evaluations, found).search(near);
    beyond(Interval<T>::between(turn, infinity<T>));
    beyond(Interval<T>::between(-infinity<T>, -turn));
    for (const RootEnclosure<T>& one : inverse) {
      if (one.lo == 0 && one.hi == 0) continue;  // at infinity, and nowhere else
      const Interval<T> t = Interval<T>(1) / Interval<T>::between(one.lo, one.hi);
      found.push_back({t.lo, t.hi, one.status});
    }
  } else {
    Isolation(along, budget, result.evaluations, found).search(range);
  }
  result.roots = Refinement(along, range, 2 * budget, result.evaluations).of(std::move(found));
  return result;
}

/// The roots alone.
template <class Surface, std::floating_point T>
[[nodiscard]] EnclosedRoots<T> roots(const Ray<T>& ray, const Surface& f,
                                     std::size_t budget = default_budget) {
  return search(ray, f, budget).roots;
}

}  // namespace rayproof::implicit
