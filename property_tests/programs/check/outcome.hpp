#pragma once
#include <string>

#include "programs/check/options.hpp"
#include "properties/report/summary.hpp"

namespace rayproof::check {

/// What `rayproof check` prints at the end: the table, the failures in full, the findings, and what may be
/// done with them; at most 120 columns wide but for the cases of failures.
[[nodiscard]] std::string text_outcome(const Options& options, const Plan& plan, const RunResult& result,
                                       const Summary& summary);

}  // namespace rayproof::check
