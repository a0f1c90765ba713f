#pragma once
#include <rayproof/formulas/corrected_flat_hit.hpp>
#include <rayproof/plane/implicit.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::plane {

/// The hit of ByEquation, corrected, with f(t) = n·p(t) + D of any of the plane's forms.
struct Correction {
  /// What is known before the ray is.
  template <class W>
  [[nodiscard]] static constexpr PlaneEquation<W> prepared(const Plane<W>& plane) {
    if (plane.form == PlaneForm::implicit) {
      return plane_equation<W>(sized<W>(plane.normal), {W(0), W(0), W(0)}, plane.d);
    }
    return plane_equation<W>(
        plane.form == PlaneForm::parametric ? sized_cross<W>(plane.u, plane.v) : sized<W>(plane.normal),
        plane.point, W(0));
  }

  template <class N>
  [[nodiscard]] static constexpr CorrectionStart<N> start(const Ray<N>& ray, const Plane<N>& plane) {
    return {ByEquation::roots(ray, plane).lo, N(0)};
  }

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

}  // namespace rayproof::plane

#include <rayproof/rounding/as_before.hpp>
