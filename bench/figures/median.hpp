#pragma once
/// \file
/// The middle of some measurements.

#include <algorithm>
#include <vector>

namespace rayproof::report {

/// The upper one of the two middle values where their count is even; `values` has one at least.
[[nodiscard]] inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace rayproof::report
