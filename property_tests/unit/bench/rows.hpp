#pragma once
/// \file
/// Rows of a report, made up.

#include "bench/figures/row.hpp"

namespace rayproof::report {

/// A row of the sphere in float.
[[nodiscard]] inline BenchRow sphere_row(const char* method, Arrangement arrangement, const char* family,
                                         double ns, std::size_t wrong, double bits) {
  BenchRow one{"sphere", method, Precision::float32, arrangement, family, ns};
  one.accuracy = {.cases = 1000, .wrong_misses = wrong, .agreed_hits = 100, .mean_bits = bits};
  return one;
}

}  // namespace rayproof::report
