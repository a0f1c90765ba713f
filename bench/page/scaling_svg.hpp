#pragma once
/// \file
/// How times grow, as plots and as tables.

#include <string>
#include <vector>

#include "bench/figures/row.hpp"

namespace rayproof::report {

/// One curve of a report as one `<svg>` that stands by itself, in light and dark: nanoseconds over size, both
/// logarithmic, a line for each method with its name at its end, and bars from the lower to the upper
/// quartile of the passes. Empty where the rows have no such curve.
[[nodiscard]] std::string scaling_in_svg(const std::vector<BenchRow>& rows, const std::string& curve);

/// A section of the page: the plot of each curve, and its table with medians and quartiles.
[[nodiscard]] std::string scaling_in_html(const std::vector<BenchRow>& rows);

/// The medians for the terminal, a table for each curve and shape.
[[nodiscard]] std::string scaling_in_text(const std::vector<BenchRow>& rows);

}  // namespace rayproof::report
