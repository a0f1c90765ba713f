#pragma once
/// \file
/// The findings of a run as people read them: in order, in words, with the commands that look into them.

#include <filesystem>
#include <string>
#include <vector>

#include "properties/finding.hpp"

namespace rayproof {

/// What breaks a contract first, then what the contracts declare, one failure after another, and numbers them
/// from 1.
void put_in_order(std::vector<Finding>& findings);

/// The findings that are declared, or those that are not, those together that are one failure to a reader: a
/// method fails alike in both precisions and on many cases, or several methods of a topic fail alike on one
/// case.
[[nodiscard]] std::vector<std::vector<Finding>> alike(const std::vector<Finding>& findings, bool is_declared);

/// What the method does with the finding's case, and what is exact: "misses a sphere of radius 1 from 4500
/// away (exact 499.88943)".
[[nodiscard]] std::string in_words(const Finding& finding);

/// A finding in one line: number, method, precision, and what is wrong.
[[nodiscard]] std::string text_finding(const Finding& finding);

/// One line for each failure that the contracts declare, the findings that are alike together: the precision
/// and the words are those of the first number. For findings in order.
[[nodiscard]] std::string text_declared(const std::vector<Finding>& findings);

/// Each failure that breaks a contract, in full: what broke, by how much, the case of the first number.
[[nodiscard]] std::string text_failures(const std::vector<Finding>& findings);

/// " --from DIR/findings.jsonl" for a run whose folder is not the usual one, so that its findings' numbers
/// are found by the commands that look into them; else empty.
[[nodiscard]] std::string from_option(const std::filesystem::path& folder);

}  // namespace rayproof
