#pragma once
/// \file
/// The middle of some measurements, and how far they spread.

#include <algorithm>
#include <utility>
#include <vector>

namespace rayproof::report {

/// The value below which this share of the values lies, 0 to 1; `values` has one at least.
[[nodiscard]] inline double quantile(std::vector<double> values, double share) {
  const auto below = static_cast<std::size_t>(share * static_cast<double>(values.size()));
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(std::min(below, values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// The upper one of the two middle values where their count is even.
[[nodiscard]] inline double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

}  // namespace rayproof::report
