#pragma once
#include <rayproof/box.hpp>
#include <rayproof/box/nearest_end.hpp>
#include <rayproof/box/slabs_inverse.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::box {

/// The nearest hit of SlabsInverse, corrected: with the face that is met f(t) = o + t·d - plane on its axis.
struct Correction {
  /// An end is off by 3.01u of itself, u the unit roundoff, and two roundings more, and by what underflows;
  /// there is none where the ray runs along the slab. An endless slab leaves all in doubt.
  template <class N>
  [[nodiscard]] static constexpr CorrectionStart<N> start(const Ray<N>& ray, const Box<N>& box) {
    const auto directed = [](const Slab<N>& slab, const N& d, const N& width) -> DirectedSlab<N> {
      const auto error_of = [&](const N& t) {
        return select(d == N(0), N(0) * width, N(5.5 * unit_roundoff<N>) * abs(t) + N(least_error<N>));
      };
      return {slab.entry, slab.exit, error_of(slab.entry), error_of(slab.exit), d < N(0)};
    };
    const auto& [x, y, z] = SlabsInverse::slabs(ray, box);
    const vec3<N> d = ray.direction, width = box.max - box.min;
    return nearest_end(ray, directed(x, d.x, width.x), directed(y, d.y, width.y), directed(z, d.z, width.z));
  }

  template <class N, class W>
  [[nodiscard]] static constexpr Linear<N> residual(const Ray<N>& ray, const Ray<W>& /*wide*/,
                                                    const CorrectionStart<N>& start,
                                                    const CorrectionStart<W>& wide_start, const Box<W>& box) {
    const N which = abs(start.face);
    const auto on_axis = [&](const vec3<N>& v) {
      return select(which == N(1), v.x, select(which == N(2), v.y, v.z));
    };
    const N plane =
        select(start.face < N(0), on_axis(narrowed_vector<N>(box.max)), on_axis(narrowed_vector<N>(box.min)));
    const N d = on_axis(ray.direction);
    const W apart = with_more_digits<W>(on_axis(ray.origin)) - with_more_digits<W>(plane);
    return {narrow(multiply_add(wide_start.t, with_more_digits<W>(d), apart)), d};
  }

  /// f is off by u(|o - plane| + |f|), W's unit roundoff, and its slope is given.
  template <class N, class W>
  [[nodiscard]] static constexpr Corrected<N> nearest(const Ray<N>& ray, const CorrectionStart<N>& start,
                                                      const Linear<N>& f, const Box<W>& /*box*/) {
    const N error = N(2 * unit_roundoff<W>) * abs(start.t * f.slope) + N(least_error<N>);
    const auto slope_error = [](const N& /*step*/) { return N(0); };
    return nearest_root(ray, newton_step(start.t, f.value, error, f.slope, slope_error));
  }
};

}  // namespace rayproof::box

#include <rayproof/rounding/as_before.hpp>
