#pragma once
#include <string>

#include "bench/figures/comparison.hpp"

namespace rayproof::report {

/// What got worse and what got better, for the terminal. `machine` is that of the older report.
[[nodiscard]] std::string comparison_in_text(const ReportComparison& comparison, const std::string& machine);
/// The same for the page.
[[nodiscard]] std::string comparison_in_html(const ReportComparison& comparison, const std::string& machine);

}  // namespace rayproof::report
