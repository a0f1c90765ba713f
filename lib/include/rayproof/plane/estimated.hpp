#pragma once
/// \file
/// A plane met with more digits, and with a bound on the error, for the rounding test.

#include <rayproof/formulas/quotient_error.hpp>
#include <rayproof/formulas/rounding_test.hpp>
#include <rayproof/plane/implicit.hpp>
#include <rayproof/plane/parametric.hpp>
#include <rayproof/plane/point_normal.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::plane {

/// The plane met in its own form, in double on numbers that are floats or in double-double on doubles, and
/// what is known of it.
///
/// Products of two given numbers are exact and their differences are rounded once, so that each component
/// of u × v is off by no more than u of its size, and so is p - o. Then n·d is off by at most 4.1u times the
/// sum of its terms' sizes, n·(p - o) by 5.1u, n·o + D by 3.1u, a determinant of w = o - p and two given
/// vectors by 6.1u. Whether the ray is parallel is sure where n·d is large beside its own error, or where
/// each of its terms is 0. Where the plane or the ray's origin is not finite no hit and no miss is sure but
/// that of a parallel ray. Nothing over- or underflows: no product is of more than three given numbers.
template <class W>
[[nodiscard]] constexpr EnclosedHit<W> estimated(const Ray<W>& ray, const Plane<W>& plane) {
  const auto d = sized<W>(ray.direction);
  using N = Leading<W>;
  const auto enclosed = [&](const FlatHit<W>& hit, const Sized<W>& L, const N& size_of_N) -> EnclosedHit<W> {
    const N t_error = quotient_error(hit.lo, size_of_N, L.size, reciprocal_bound(abs(leading(L.value))));
    return {hit, t_error, N(0), N(0), (has_digits(L) && size_of_N < N(infinity<W>)) || L.size == N(0)};
  };
  if (plane.form == PlaneForm::implicit) {
    const auto n = sized<W>(plane.normal);
    return enclosed(ByEquation::roots(ray, plane), dot(n, d),
                    dot(n, sized<W>(ray.origin)).size + abs(leading(plane.d)));
  }
  const bool is_parametric = plane.form == PlaneForm::parametric;
  const auto n = is_parametric ? sized_cross<W>(plane.u, plane.v) : sized<W>(plane.normal);
  const auto w = sized<W>(ray.origin - plane.point);
  const Sized<W> L = dot(n, d);
  if (!is_parametric) {
    return enclosed(ByPointAndNormal::roots(ray, plane), L, dot(n, w).size);
  }
  EnclosedHit<W> result = enclosed(ByParameters::roots(ray, plane), L, dot(n, w).size);
  const N per_L = reciprocal_bound(abs(leading(L.value)));
  result.u_error = quotient_error(result.hit.u, dot(cross(w, sized<W>(plane.v)), d).size, L.size, per_L);
  result.v_error = quotient_error(result.hit.v, dot(cross(sized<W>(plane.u), w), d).size, L.size, per_L);
  return result;
}

}  // namespace rayproof::plane

#include <rayproof/rounding/as_before.hpp>
