#pragma once
/// \file
/// The run's outcome as plain text for a terminal.

#include <string>

#include "properties/report/summary.hpp"

namespace rayproof {

/// Subject × property: a sign for each, the number of cases, and the worst errors beside what is promised.
[[nodiscard]] std::string text_table(const Summary& summary);

/// The worst errors of each method on each family, one table for each topic and measure.
[[nodiscard]] std::string text_families(const Plan& plan, const RunResult& result);

/// What the generators produced, family by family.
[[nodiscard]] std::string text_labels(const RunResult& result);

/// A finding in two lines: what broke, and the case.
[[nodiscard]] std::string text_finding(const Finding& finding);

/// The worst figures as the contracts write them, ready to be copied.
[[nodiscard]] std::string text_measured(const Summary& summary);

}  // namespace rayproof
