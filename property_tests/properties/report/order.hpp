#pragma once
/// \file
/// The findings of a run in the order in which people read them.

#include <vector>

#include "properties/engine.hpp"

namespace rayproof {

/// What breaks a contract first, then what the contracts declare, one failure after another, and numbers them
/// from 1.
void put_in_order(std::vector<Finding>& findings);

/// The findings that are declared, or those that are not, those together that are one failure to a reader: a
/// method fails alike in both precisions and on many cases, or several methods of a topic fail alike on one
/// case.
[[nodiscard]] std::vector<std::vector<Finding>> alike(const std::vector<Finding>& findings, bool is_declared);

}  // namespace rayproof
