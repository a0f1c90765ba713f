#pragma once
/// \file
/// What pictures and texts say of answers, whatever the topic.

#include <string>
#include <vector>

#include "case/answer.hpp"
#include "case/case.hpp"

namespace rayproof::viz {

/// The t or x of the answer, ascending; none for a missing answer.
[[nodiscard]] std::vector<double> values_of(const Answer* answer);

/// "hit on an edge", "miss (parallel)", "two roots", "inside", "not given".
[[nodiscard]] std::string verdict_of(const Answer* answer);

/// Whether both are given and differ in how many hits or roots there are, of what kind, or in why there is
/// none.
[[nodiscard]] bool verdicts_differ(const Answer* exact, const Answer* claimed);

/// The worst distance of a claimed value from the exact one of the same rank, as count_ulps counts.
[[nodiscard]] double worst_ulps(const Answer* exact, const Answer* claimed, Precision precision);

/// "Exact: hit. Claimed: miss, which is wrong." in one line.
[[nodiscard]] std::string headline_of(const Case& one, const Answer* exact, const Answer* claimed);

}  // namespace rayproof::viz
