#pragma once
/// \file
/// The figures of a run as plain text.

#include <string>

#include "properties/report/summary.hpp"

namespace rayproof {

/// The worst errors of each method on each family, one table for each topic and measure.
[[nodiscard]] std::string text_families(const Plan& plan, const RunResult& result);

/// What the generators produced, family by family.
[[nodiscard]] std::string text_labels(const RunResult& result);

/// The worst figures as the contracts write them, ready to be copied.
[[nodiscard]] std::string text_measured(const Summary& summary);

}  // namespace rayproof
