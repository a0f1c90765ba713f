#pragma once
/// \file
/// A run as plain text: which method keeps which claim, the findings with their numbers, the figures.

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

/// The status of a row for a claim, which several properties may serve: the one that matters most.
[[nodiscard]] ClaimStatus status_of(const Row& row, Claim claim);

/// One line for each failure that the contracts declare, the findings that are alike together (order.hpp):
/// the precision and the words are those of the first number. For findings in order.
[[nodiscard]] std::string text_declared(const RunResult& result);

/// Each failure that breaks a contract, in full: what broke, by how much, the case of the first number.
[[nodiscard]] std::string text_failures(const RunResult& result);

/// A finding in one line: number, method, precision, and what is wrong.
[[nodiscard]] std::string text_finding(const Finding& finding);

/// The worst errors of each method on each family, one table for each topic and measure.
[[nodiscard]] std::string text_families(const Plan& plan, const RunResult& result);

/// What the generators produced, family by family.
[[nodiscard]] std::string text_labels(const RunResult& result);

/// The worst figures as the contracts write them, ready to be copied.
[[nodiscard]] std::string text_measured(const Summary& summary);

}  // namespace rayproof
