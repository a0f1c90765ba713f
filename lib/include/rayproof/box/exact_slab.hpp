#pragma once
/// \file
/// Slabs in exact arithmetic: the entries and exits are ratios of exact numbers, and no comparison is
/// rounded.

#include <array>
#include <rayproof/formulas/exact_rounding.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::box {

/// When a line is between two parallel planes, as `Slab` has it. Where it runs parallel to them, entry and
/// exit mean nothing, and it is in the slab for all t or for none.
template <class Distance, class Speed>
struct ExactSlab {
  bool is_parallel;
  bool is_between;  ///< of the origin
  ExactRatio<Distance, Speed> entry, exit;

  /// As `slab_of`: the planes are `below` and `above` ahead of a line that gains `speed` per unit of t.
  ExactSlab(const Speed& speed, const Distance& below, const Distance& above)
      : is_parallel(sign(speed) == 0),
        is_between(sign(below) <= 0 && sign(above) >= 0),
        entry{sign(speed) > 0 ? below : above, speed},
        exit{sign(speed) > 0 ? above : below, speed} {}
};

/// What three slabs have in common, as `chord`: the verdict is exact, and each end is rounded once.
template <std::floating_point T, class Slab>
[[nodiscard]] Roots<T> exact_chord(const Ray<T>& ray, const std::array<Slab, 3>& slabs) {
  step<T>(
      "Compare entries and exits by cross products, and round the last and the first",
      "The cross products of two quotients are exact: so is the verdict, and only the answer is rounded.");
  const decltype(Slab::entry)* entry = nullptr;
  const decltype(Slab::exit)* exit = nullptr;
  for (const Slab& slab : slabs) {
    if (slab.is_parallel && !slab.is_between) return no_roots<T>;
    if (slab.is_parallel) continue;
    if (entry == nullptr || slab.entry.compare(*entry) > 0) entry = &slab.entry;
    if (exit == nullptr || slab.exit.compare(*exit) < 0) exit = &slab.exit;
  }
  if (entry == nullptr) return no_roots<T>;  // the direction is 0
  const int length = exit->compare(*entry);
  if (length < 0) return no_roots<T>;
  const T t_entry = rounded(ray, *entry);
  if (length == 0) return {T(0), t_entry, t_entry};
  return ascending(T(1), t_entry, rounded(ray, *exit));
}

}  // namespace rayproof::box

#include <rayproof/rounding/as_before.hpp>
