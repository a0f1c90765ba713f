#pragma once
#include <rayproof/formulas/corrected_flat_hit.hpp>
#include <rayproof/triangle/clear_sides.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::triangle {

/// The verdict of the three sides without more digits, where it is clear, and their t, corrected.
struct Correction : InOnePlane {
  /// What is known before the ray is. Edges are rounded once, and so are products of two.
  template <class W>
  [[nodiscard]] static constexpr PlaneEquation<W> prepared(const Triangle<W>& triangle) {
    return plane_equation<W>(cross(sized<W>(triangle.b - triangle.a), sized<W>(triangle.c - triangle.a)),
                             triangle.a, W(0));
  }

  /// The t of a hit; infinity for a miss, and NaN where neither is clear.
  template <class N>
  [[nodiscard]] static constexpr CorrectionStart<N> start(const Ray<N>& ray, const Triangle<N>& triangle) {
    const auto sides = ClearSides<N>::of(ray, triangle, N(least_length<N>));
    const N t = sides.at_origin.value / sides.D.value;
    // The terms of a side come to 1/(16u) of its error at most: none of these overflows, and none does before
    // another that would take it back.
    const N error = max(sides.U.error, max(sides.V.error, sides.W.error));
    const Mask<N> is_moderate = error < N(1 / least_error<N>);
    const Mask<N> is_hit = is_moderate && sides.is_inside() && t < N(infinity<N>);
    const Mask<N> is_miss = is_moderate && sides.is_miss();
    return {select(is_miss, N(infinity<N>), select(is_hit, t, N(not_a_number<N>))), N(0)};
  }
};

}  // namespace rayproof::triangle

#include <rayproof/rounding/as_before.hpp>
