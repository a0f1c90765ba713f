#pragma once
/// \file
/// All that terminal and page show.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/figures/choice.hpp"
#include "bench/figures/comparison.hpp"
#include "bench/page/plot.hpp"

namespace rayproof::report {

struct Conclusions {
  Measurements figures{};
  std::vector<MethodSummary> summaries{};
  std::vector<Choice> choices{};
  std::vector<Plot> plots{};
  /// What an older report says beside this one, and its machine.
  std::optional<std::pair<ReportComparison, std::string>> baseline{};
};

}  // namespace rayproof::report
