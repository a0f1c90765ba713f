#pragma once
/// \file
/// Slabs met with more digits, and with bounds on the errors of their ends, for the rounding test.

#include <rayproof/box/slab.hpp>
#include <rayproof/formulas/rounding_test.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::box {

/// A slab, and bounds on the errors of its ends where `is_sure`.
template <class W>
struct BoundedSlab {
  W entry, exit;
  Leading<W> entry_error, exit_error;
  Mask<W> is_sure;
};

/// The chord that slabs have in common. Whichever slab the last entry comes from, it lies between the largest
/// lower and the largest upper bound of all; so does the first exit. Where their bounds do not overlap the
/// order is sure, and with it hit or miss.
template <class W, class... More>
[[nodiscard]] constexpr Enclosed<W> enclosed_chord(const BoundedSlab<W>& first, const More&... more) {
  W entry = first.entry, exit = first.exit;
  W entry_low = entry - first.entry_error, entry_high = entry + first.entry_error;
  W exit_low = exit - first.exit_error, exit_high = exit + first.exit_error;
  ((entry = max(entry, more.entry)), ...);
  ((entry_low = max(entry_low, more.entry - more.entry_error)), ...);
  ((entry_high = max(entry_high, more.entry + more.entry_error)), ...);
  ((exit = min(exit, more.exit)), ...);
  ((exit_low = min(exit_low, more.exit - more.exit_error)), ...);
  ((exit_high = min(exit_high, more.exit + more.exit_error)), ...);
  Mask<W> is_sure = first.is_sure && (entry_high < exit_low || exit_high < entry_low);
  ((is_sure = is_sure && more.is_sure), ...);
  const auto larger = [](const W& x, const W& y) { return max(leading(x), leading(y)); };
  return {chord(entry, exit), larger(entry_high - entry, entry - entry_low),
          larger(exit_high - exit, exit - exit_low), is_sure};
}

}  // namespace rayproof::box

#include <rayproof/rounding/as_before.hpp>
