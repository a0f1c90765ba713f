#pragma once
/// \file
/// The findings of a run as lines for a terminal, each with its number.

#include <string>

#include "properties/engine.hpp"

namespace rayproof {

/// One line for each failure that the contracts declare, the findings that are alike together (order.hpp):
/// the precision and the words are those of the first number. For findings in order.
[[nodiscard]] std::string text_declared(const RunResult& result);

/// Each failure that breaks a contract, in full: what broke, by how much, the case of the first number.
[[nodiscard]] std::string text_failures(const RunResult& result);

/// A finding in one line: number, method, precision, and what is wrong.
[[nodiscard]] std::string text_finding(const Finding& finding);

}  // namespace rayproof
