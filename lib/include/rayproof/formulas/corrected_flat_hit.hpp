#pragma once
/// \file
/// The hit of a ray with the plane of a flat figure, corrected.

#include <rayproof/arithmetics/sized.hpp>
#include <rayproof/formulas/newton_step.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// normal·(q - point) + d = 0, where each component of the normal is off by at most 4u of `size`, u the unit
/// roundoff, and the rest is given.
template <class W>
struct PlaneEquation {
  vec3<W> normal;
  double size;
  vec3<W> point;
  W d;
};
template <class To, class From>
[[nodiscard]] constexpr PlaneEquation<To> convert(const PlaneEquation<From>& plane) {
  return {convert<To>(plane.normal), plane.size, convert<To>(plane.point), To(plane.d)};
}

/// The size of the component that has the largest.
template <class W>
[[nodiscard]] constexpr Leading<W> largest_size(const Vec3<Sized<W>>& v) {
  return max(v.x.size, max(v.y.size, v.z.size));
}

template <class W>
[[nodiscard]] constexpr PlaneEquation<W> plane_equation(const Vec3<Sized<W>>& n, const vec3<W>& point,
                                                        const W& d) {
  return {{n.x.value, n.y.value, n.z.value}, largest_size(n), point, d};
}

/// The sum of a vector's magnitudes.
template <class N>
[[nodiscard]] constexpr N sum_of_magnitudes(const vec3<N>& v) {
  return abs(v.x) + abs(v.y) + abs(v.z);
}

/// f(t) = n·(o - p + t·d) + D, whose slope is n·d. `wide` is the ray with more digits.
template <class N, class W>
[[nodiscard]] constexpr Linear<N> flat_residual(const Ray<N>& ray, const Ray<W>& wide, const W& t,
                                                const PlaneEquation<W>& plane) {
  const vec3<W> w = wide.origin - plane.point, q = multiply_add(t, wide.direction, w);
  return {narrow(dot(plane.normal, q) + plane.d), dot(narrowed_vector<N>(plane.normal), ray.direction)};
}

/// The zero of that function, rounded, in which |n| is no component's size more than `size_of_n`.
///
/// u is W's unit roundoff: o - p and its sum with t·d, which is exact, are rounded once each, to u of |o - p|
/// and |t·d|; n is off by 4u of its size, and three products and sums by 4u. So f is off by 10u times the
/// sizes of its terms, and n·d, which is found without more digits, by four of N's unit roundoffs times its
/// own.
///
/// `least_error` is added to what may underflow before a product with it is formed.
template <class W, class N>
[[nodiscard]] constexpr Corrected<N> corrected_flat_hit(const Ray<N>& ray, const N& t, const Linear<N>& f,
                                                        const N& size_of_n, const vec3<N>& point,
                                                        const N& size_of_d) {
  const N n = size_of_n + N(least_error<N>);
  const N size_of_slope = n * sum_of_magnitudes<N>(ray.direction);
  const N size = n * sum_of_magnitudes<N>(ray.origin - point) + abs(t) * size_of_slope + size_of_d;
  const N error = N(12 * unit_roundoff<W>) * size + N(least_error<N>);
  const auto slope_error = [&](const N& /*step*/) {
    return N(6 * unit_roundoff<N>) * size_of_slope + N(least_error<N>);
  };
  return newton_step(t, f.value, error, f.slope, slope_error);
}

/// The correction of a figure in one plane, from where a method of its own starts it.
struct InOnePlane {
  template <class N, class W>
  [[nodiscard]] static constexpr Linear<N> residual(const Ray<N>& ray, const Ray<W>& wide,
                                                    const CorrectionStart<N>& /*narrow*/,
                                                    const CorrectionStart<W>& start,
                                                    const PlaneEquation<W>& plane) {
    return flat_residual(ray, wide, start.t, plane);
  }

  template <class N, class W>
  [[nodiscard]] static constexpr Corrected<N> nearest(const Ray<N>& ray, const CorrectionStart<N>& start,
                                                      const Linear<N>& f, const PlaneEquation<W>& plane) {
    return nearest_root(ray, corrected_flat_hit<W>(ray, start.t, f, N(plane.size),
                                                   narrowed_vector<N>(plane.point), abs(narrow(plane.d))));
  }
};

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
