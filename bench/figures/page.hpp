#pragma once
#include <string>

#include "bench/figures/plot.hpp"

namespace rayproof::report {

/// The page out/report/index.html: one self-contained file.
[[nodiscard]] std::string to_page(const Figures& figures, const std::vector<Summary>& summaries,
                                  const std::vector<Plot>& plots);

}  // namespace rayproof::report
