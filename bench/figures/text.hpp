#pragma once
#include <string>

#include "bench/figures/row.hpp"
#include "bench/figures/summary.hpp"

namespace rayproof::report {

/// What the terminal shows: a table for each shape and precision, and the headline.
[[nodiscard]] std::string to_text(const Measurements& figures, const std::vector<MethodSummary>& summaries);

/// A figure in a table: "0.55", "1.2e+04", "inf", and a dash where there is none.
[[nodiscard]] std::string figure(double x);

}  // namespace rayproof::report
