#pragma once
/// \file
/// A plane met in double, with a bound on the error, for the rounding test.

#include <rayproof/formulas/quotient_error.hpp>
#include <rayproof/formulas/rounding_test.hpp>
#include <rayproof/plane/implicit.hpp>
#include <rayproof/plane/parametric.hpp>
#include <rayproof/plane/point_normal.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::plane {

/// The plane met in its own form, in double on numbers that are floats, and what is known of it.
///
/// u = 2^-53. Products of two floats are exact and their differences are rounded once, so that each component
/// of u × v is off by no more than u of itself, and so is p - o. Then n·d⃗ is off by at most 4.1u times the
/// sum of its terms' sizes, n·(p - o) by 5.1u, n·o + d by 3.1u, a determinant of w = o - p and two given
/// vectors by 6.1u. Whether the ray is parallel is sure where n·d⃗ is large beside its own error, or where
/// each of its terms is 0; a ray or plane that is not finite is never sure of a hit, and has none. Nothing
/// over- or underflows: no product is of more than three floats.
template <class W>
[[nodiscard]] constexpr EnclosedHit<W> estimated(const Ray<W>& ray, const Plane<W>& plane) {
  const vec3<W> d = ray.direction;
  const auto enclosed = [&](const FlatHit<W>& hit, const vec3<W>& n, const W& size_of_N) -> EnclosedHit<W> {
    const W along = abs(dot(n, d));
    const W size_of_L = size_of_dot<W>(n, d);
    const W t_error = quotient_error(hit.lo, size_of_N, size_of_L, reciprocal_bound(along));
    return {hit, t_error, W(0), W(0), has_digits(along, size_of_L) || size_of_L == W(0)};
  };
  if (plane.form == PlaneForm::implicit) {
    return enclosed(ByEquation::roots(ray, plane), plane.normal,
                    size_of_dot<W>(plane.normal, ray.origin) + abs(plane.d));
  }
  const vec3<W> n = normal_of(plane);
  const vec3<W> w = ray.origin - plane.point;
  const W size_of_N = size_of_dot<W>(n, w);
  if (plane.form == PlaneForm::point_normal) {
    return enclosed(ByPointAndNormal::roots(ray, plane), n, size_of_N);
  }
  EnclosedHit<W> result = enclosed(ByParameters::roots(ray, plane), n, size_of_N);
  const W size_of_L = size_of_dot<W>(n, d);
  const W per_L = reciprocal_bound(abs(dot(n, d)));
  result.u_error = quotient_error(result.hit.u, size_of_volume<W>(w, plane.v, d), size_of_L, per_L);
  result.v_error = quotient_error(result.hit.v, size_of_volume<W>(plane.u, w, d), size_of_L, per_L);
  return result;
}

}  // namespace rayproof::plane

#include <rayproof/rounding/as_before.hpp>
