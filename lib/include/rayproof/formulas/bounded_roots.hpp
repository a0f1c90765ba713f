#pragma once
/// \file
/// The rounding test of rays that are taken into an object's space: their numbers are rounded there, and
/// carry bounds on their own errors (Bounded).

#include <rayproof/arithmetics/bounded.hpp>
#include <rayproof/arithmetics/sized.hpp>
#include <rayproof/formulas/exact_map.hpp>
#include <rayproof/formulas/rounding_test.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// A bound on the error of x, and two roundings: the rounding test's.
template <class W>
[[nodiscard]] constexpr Leading<W> error_with_room(const Bounded<W>& x) {
  using N = Leading<W>;
  return x.error + N(4 * unit_roundoff<W>) * min(abs(leading(x.value)), N(0x1p1000));
}

/// Two roots, or none, of which all errors are known: sure where the discriminant is surely not 0. Roots that
/// are NaN beside one above 0 are left to the rounding test, which is never sure of them.
template <class W>
[[nodiscard]] constexpr Enclosed<W> enclosed_by_bounds(const Roots<Bounded<W>>& roots) {
  const auto& [D, lo, hi] = roots;
  return {{D.value, lo.value, hi.value}, error_with_room(lo), error_with_room(hi), !D.may_be_zero()};
}

/// The hit of a flat figure: sure where every comparison that led to its verdict is.
template <class W>
[[nodiscard]] constexpr EnclosedHit<W> enclosed_by_bounds(const FlatHit<Bounded<W>>& hit) {
  const W t = hit.lo.value;
  return {{{hit.discriminant.value, t, t}, hit.u.value, hit.v.value},
          error_with_room(hit.lo),
          error_with_room(hit.u),
          error_with_room(hit.v),
          hit.discriminant.error == Leading<W>(0)};
}

/// a × b with more digits: the products of given numbers are exact there, so each component is rounded once,
/// and is 0 where the exact one is.
template <std::floating_point T>
[[nodiscard]] Vec3<Bounded<WiderThan<T>>> bounded_cross(const glm::vec<3, T>& a, const glm::vec<3, T>& b) {
  using W = WiderThan<T>;
  const auto rounded_once = [](const Sized<W>& x) {
    return Bounded<W>(x.value, running_error::of_sum(x.value, x.size));
  };
  const Vec3<Sized<W>> n = sized_cross<W>(convert<W>(a), convert<W>(b));
  return {rounded_once(n.x), rounded_once(n.y), rounded_once(n.z)};
}

/// The space of an object whose map is given exactly, with bounds on what its inverse is off by.
template <std::floating_point T>
[[nodiscard]] ObjectSpace<Bounded<WiderThan<T>>> bounded_space(const ObjectSpace<T>& space) {
  using B = Bounded<WiderThan<T>>;
  const vec3<T>&a = space.column_x, &b = space.column_y, &c = space.column_z;
  return object_space_of_cofactors<B>(convert<B>(a), convert<B>(b), convert<B>(c),
                                      convert<B>(space.translation), bounded_cross(b, c), bounded_cross(c, a),
                                      bounded_cross(a, b));
}

/// A method's roots of a ray in the world by its `enclosed_in_space`, with more digits and running error
/// bounds, where that is sure; else with the map composed exactly. `bounded` is the space's bounded_space.
template <class Method, std::floating_point T, template <class> class Shape>
[[nodiscard]] auto quick_or_exact_roots(const ObjectSpace<T>& space,
                                        const ObjectSpace<Bounded<WiderThan<T>>>& bounded, const Ray<T>& ray,
                                        const Shape<T>& shape) {
  using B = Bounded<WiderThan<T>>;
  const Ray<B> seen = to_object(bounded, convert<B>(ray));
  const auto quick = rounded_roots(convert<double>(ray), Method::enclosed_in_space(seen, convert<B>(shape)));
  return quick.is_sure ? convert<T>(quick.answer) : met_exactly<Method>(space, ray, shape);
}
template <class Method, std::floating_point T, template <class> class Shape>
[[nodiscard]] auto quick_or_exact_roots(const ObjectSpace<T>& space, const Ray<T>& ray,
                                        const Shape<T>& shape) {
  return quick_or_exact_roots<Method>(space, bounded_space(space), ray, shape);
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
