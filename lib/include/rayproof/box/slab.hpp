#pragma once
/// \file
/// The slab between two parallel planes: when a line is in it, and when it is in three of them at once.

#include <rayproof/method/narration.hpp>
#include <rayproof/roots.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::steps {
inline constexpr Step measure_planes{
    "Measure the planes from the ray's origin",
    "The six planes of the box lie at these signed distances from the ray's origin, along the axes."};
}  // namespace rayproof::steps

namespace rayproof::box {

/// The line is between the planes for t in [entry, exit]: the whole line is [-inf, inf], nothing is
/// [inf, -inf] or has a NaN in it.
template <class T>
struct Slab {
  T entry, exit;
};

/// A line that gains `speed` per unit of t on its way from the plane `below` ahead of it to the one `above`,
/// which it meets at `t_below` and `t_above`. Where `speed` is 0 those two are not looked at: the line is in
/// the slab for all t or for none, planes included.
template <class T>
[[nodiscard]] constexpr Slab<T> slab_of(const T& speed, const T& below, const T& above, const T& t_below,
                                        const T& t_above) {
  const Mask<T> is_rising = T(0) < speed;
  const Mask<T> is_parallel = speed == T(0);
  const Mask<T> is_between = below <= T(0) && T(0) <= above;
  const T if_parallel = select(is_between, T(infinity<T>), T(-infinity<T>));
  return {select(is_parallel, -if_parallel, select(is_rising, t_below, t_above)),
          select(is_parallel, if_parallel, select(is_rising, t_above, t_below))};
}

/// The same with both t by division.
template <class T>
[[nodiscard]] constexpr Slab<T> slab_of(const T& speed, const T& below, const T& above) {
  return slab_of(speed, below, above, below / speed, above / speed);
}

/// The slab, its ends with the names that they have in a walkthrough.
template <class T>
[[nodiscard]] constexpr Slab<T> named_slab(const char* in, const char* out, const Slab<T>& slab) {
  return {named(in, slab.entry), named(out, slab.exit)};
}

/// When the line is in all slabs: from the last entry to the first exit, which may lie before it. The entry
/// is NaN where a slab is never met or holds a NaN, which `max` could lose, and where neither end is finite:
/// then the direction is 0 or the origin infinite.
template <class T, class... More>
[[nodiscard]] constexpr Slab<T> overlap(const Slab<T>& first, const More&... more) {
  step<T>("Keep the last entry and the first exit",
          "The ray is inside where all these intervals of t overlap: from the largest entry to the smallest "
          "exit. Where the exit comes first, it misses.");
  T entry = first.entry;
  T exit = first.exit;
  Mask<T> is_hit = first.entry <= first.exit;
  ((entry = max(entry, more.entry)), ...);
  ((exit = min(exit, more.exit)), ...);
  ((is_hit = is_hit && more.entry <= more.exit), ...);
  is_hit = is_hit && (abs(entry) < T(infinity<T>) || abs(exit) < T(infinity<T>));
  return {named("t_entry", select(is_hit, entry, T(not_a_number<T>))), named("t_exit", exit)};
}

}  // namespace rayproof::box

#include <rayproof/rounding/as_before.hpp>
