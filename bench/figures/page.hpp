#pragma once
#include <string>

#include "bench/figures/plot.hpp"

namespace rayproof::report {

/// The page out/report/index.html: one self-contained file.
[[nodiscard]] std::string to_page(const Measurements& figures, const std::vector<MethodSummary>& summaries,
                                  const std::vector<Plot>& plots);

}  // namespace rayproof::report
