#pragma once
/// \file
/// What rayproof check prints at the end.

#include <string>

#include "programs/check/options.hpp"
#include "properties/report/summary.hpp"

namespace rayproof::check {

/// The table, the failures in full, the findings, and what may be done with them; at most 120 columns wide
/// but for the cases of failures.
[[nodiscard]] std::string text_outcome(const Options& options, const Plan& plan, const RunResult& result,
                                       const Summary& summary);

/// The same of programs: the findings in full, and what was judged of each shape.
[[nodiscard]] std::string text_of_guests(const Options& options, const Plan& plan, const RunResult& result);

}  // namespace rayproof::check
