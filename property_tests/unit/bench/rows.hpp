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

/// What a curve has at one size, with passes that spread by a tenth about it.
[[nodiscard]] inline BenchRow curve_row(const char* curve, const char* shape, const char* method,
                                        std::size_t size, double ns) {
  BenchRow one{.shape = shape, .method = method, .family = curve, .ns_per_ray = ns};
  one.passes_ns = {0.9 * ns, 0.95 * ns, ns, 1.05 * ns, 1.1 * ns};
  one.size = size;
  return one;
}

}  // namespace rayproof::report
