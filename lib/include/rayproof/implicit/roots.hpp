#pragma once
/// \file
/// All hits of a ray with a surface f(x, y, z) = 0, none of them missed.

#include <rayproof/formulas/finite.hpp>
#include <rayproof/implicit/isolate.hpp>
#include <rayproof/implicit/refine.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::implicit {

/// A power of two, about the t at which the ray is as far from its origin as the origin from the world's: to
/// either side of it lie the t's that matter and the 1/t's that do.
template <std::floating_point P>
[[nodiscard]] P turning_point(const Ray<P>& ray) {
  const auto largest = [](const vec3<P>& v) { return max(abs(v.x), max(abs(v.y), abs(v.z))); };
  const P apart = exponent(max(largest(ray.origin), P(1))) - exponent(largest(ray.direction));
  constexpr P most = P(int{std::numeric_limits<P>::max_exponent / 2});
  return scale_exponent(P(1), max(-most, min(most, apart + 2)));
}

/// What a search came to, and how many evaluations of f its steps took; a few at ends of ranges are extra.
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
  // f(p(t)) as a function of t in any arithmetic.
  const auto along = [&]<class N>(const N& t) -> N {
    const vec3<N> p = point_at(convert<N>(ray), t);
    if constexpr (Homogeneous<Surface, N>) {
      return f(p.x, p.y, p.z, N(1));
    } else {
      return f(p.x, p.y, p.z);
    }
  };
  const auto range = Interval<T>::between(ray.t_min, ray.t_max);
  EnclosedRoots<T> found;
  const auto search_in = [&](const Interval<T>& part) {
    Isolation(along, budget, result.evaluations, found).search(part, [](const auto&) { return false; });
  };
  if constexpr (Homogeneous<Surface, Interval<T>>) {
    // f(s·origin + direction, s), which for s = 1/t has the same roots: a root at s = 0 is a direction of the
    // surface at infinity, and no hit.
    const auto far = [&]<class N>(const N& s) -> N {
      const vec3<N> p = s * convert<N>(ray.origin) + convert<N>(ray.direction);
      return f(p.x, p.y, p.z, s);
    };
    const T turn = turning_point(ray);
    EnclosedRoots<T> inverse;
    const auto search_beyond = [&](const Interval<T>& part) {
      Isolation(far, budget, result.evaluations, inverse)
          .search(Interval<T>(1) / part, [&](const Interval<T>& s) {
            ++result.evaluations;  // a ray along a cylinder: no root, but a double one at infinity
            return !along(Interval<T>(1) / s).contains(T(0));
          });
    };
    search_in(intersection(range, Interval<T>::between(-turn, turn)));
    search_beyond(intersection(range, Interval<T>::between(turn, infinity<T>)));
    search_beyond(intersection(range, Interval<T>::between(-infinity<T>, -turn)));
    for (const RootEnclosure<T>& one : inverse) {
      if (one.lo == 0 && one.hi == 0) continue;  // at infinity, and nowhere else
      const Interval<T> t = Interval<T>(1) / Interval<T>::between(one.lo, one.hi);
      found.push_back({t.lo, t.hi, one.status});
    }
  } else {
    search_in(range);
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

#include <rayproof/rounding/as_before.hpp>
