#pragma once
/// \file
/// The table of a run: which method keeps which claim.

#include <array>
#include <string>

#include "properties/report/summary.hpp"

namespace rayproof {

/// One line for each method with a mark for each claim, both precisions together (two marks, float32 first,
/// where they differ), and its wrong verdicts among the cases of its domain; under it what the marks mean. No
/// line is wider than 120 columns.
[[nodiscard]] std::string text_table(const Summary& summary);

/// A claim's name in two lines, where it is long: "resi-" above "dual".
[[nodiscard]] std::array<std::string, 2> head_of(Claim claim);

/// The mark of a row for a claim, which several properties may serve: the one that matters most.
[[nodiscard]] Mark mark_of(const Row& row, Claim claim);

}  // namespace rayproof
