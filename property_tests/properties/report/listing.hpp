#pragma once
/// \file
/// The findings of a run as lines for a terminal, each with its number.

#include <string>

#include "properties/engine.hpp"

namespace rayproof {

/// One line for each failure that the contracts declare, the findings that are alike together (order.hpp):
/// the precision and the words are those of the first number. For findings in order.
[[nodiscard]] std::string text_declared(const RunResult& result);

/// A finding that breaks what is claimed, in full: what broke, by how much, the case.
[[nodiscard]] std::string text_failure(const Finding& finding);

/// A finding in one line: number, method, precision, and what is wrong.
[[nodiscard]] std::string text_finding(const Finding& finding);

}  // namespace rayproof
