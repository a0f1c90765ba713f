#pragma once
/// \file
/// Whether a target's flags let the library round as it is written.

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// Whether a product is rounded before it is added, in the very target that calls this. Where it is not, no
/// method's promise holds there: under clang++'s -ffp-contract=fast, which the headers cannot overrule, on a
/// processor with fused multiply-adds.
[[nodiscard]] inline bool rounds_as_written() {
  // The product is 1 - 2^-60, rounded 1.
  const volatile double above = 1 + 0x1p-30, below = 1 - 0x1p-30, minus_one = -1;
  const double x = above, y = below, z = minus_one;
  return x * y + z == 0;
}

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
