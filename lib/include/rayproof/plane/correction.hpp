#pragma once
#include <rayproof/formulas/corrected_flat_hit.hpp>
#include <rayproof/plane/implicit.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::plane {

/// The hit of ByEquation, corrected, with f(t) = n·p(t) + D of any of the plane's forms.
struct Correction : InOnePlane {
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
};

}  // namespace rayproof::plane

#include <rayproof/rounding/as_before.hpp>
