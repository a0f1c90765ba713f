#pragma once
/// \file
/// Which of six faces a ray meets first inside its interval, where slabs met without more digits leave no
/// doubt.

#include <rayproof/box/slab.hpp>
#include <rayproof/formulas/newton_step.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::box {

/// The ends of a slab with bounds on their errors, and whether the line enters it through the second of its
/// two faces. Bounds that are not finite leave all in doubt; ends that are not have the bound 0.
template <class N>
struct DirectedSlab {
  N entry, exit, entry_error, exit_error;
  Mask<N> enters_second;
};

/// The largest of three numbers that are known to within bounds: which one that is, and where it lies.
template <class N>
struct Largest {
  N value, low, high, which;
  Mask<N> is_known;    ///< every bound is finite
  Mask<N> is_certain;  ///< of which one it is

  /// \param x, error three numbers and bounds on their errors
  [[nodiscard]] static constexpr Largest of(const N (&x)[3], const N (&error)[3]) {
    const N value = max(x[0], max(x[1], x[2]));
    const N low = max(x[0] - error[0], max(x[1] - error[1], x[2] - error[2]));
    const N high[3] = {x[0] + error[0], x[1] + error[1], x[2] + error[2]};
    const N larger = max(high[0], high[1]), smaller = min(high[0], high[1]);
    const N second = max(smaller, min(larger, high[2]));
    const N which = select(x[0] == value, N(1), select(x[1] == value, N(2), N(3)));
    const Mask<N> is_known = error[0] + error[1] + error[2] < N(infinity<N>);
    return {value, low, max(larger, high[2]), which, is_known, second < low};
  }
};

/// Where the correction of the nearest hit starts: at the face that the ray meets first inside its interval.
template <class N>
[[nodiscard]] constexpr CorrectionStart<N> nearest_end(const Ray<N>& ray, const DirectedSlab<N>& x,
                                                       const DirectedSlab<N>& y, const DirectedSlab<N>& z) {
  const auto entry =
      Largest<N>::of({x.entry, y.entry, z.entry}, {x.entry_error, y.entry_error, z.entry_error});
  const auto exit = Largest<N>::of({-x.exit, -y.exit, -z.exit}, {x.exit_error, y.exit_error, z.exit_error});
  const Mask<N> is_known = entry.is_known && exit.is_known;
  const Mask<N> is_hit = entry.high < -exit.high, is_miss = -exit.low < entry.low;

  const Mask<N> is_entry = ray.t_min <= entry.value;
  const Mask<N> is_certain =
      is_hit && ((is_entry && entry.is_certain) || (!is_entry && entry.high < ray.t_min && exit.is_certain));
  const N t = select(is_entry, entry.value, -exit.value);
  const N otherwise = select(is_known && is_miss, N(infinity<N>), N(not_a_number<N>));

  const N which = select(is_entry, entry.which, exit.which);
  const Mask<N> is_first = which == N(1), is_second = which == N(2);
  const Mask<N> enters_second = (is_first && x.enters_second) || (is_second && y.enters_second) ||
                                (!is_first && !is_second && z.enters_second);
  return {select(is_known && is_certain, t, otherwise), select(enters_second == is_entry, -which, which)};
}

}  // namespace rayproof::box

#include <rayproof/rounding/as_before.hpp>
