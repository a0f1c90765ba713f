#pragma once
/// \file
/// The tables of the page of a check, in HTML.

#include <string>

#include "properties/report/report.hpp"

namespace rayproof {

/// What each method claims, and what came of it: a sign for each property.
[[nodiscard]] std::string claims_table(const Summary& summary);

/// The worst errors of each method beside the bounds that it promises, and what the words mean.
[[nodiscard]] std::string errors_table(const Summary& summary);

/// The same of each family, folded.
[[nodiscard]] std::string family_table(const RunResult& result);

/// What cases the families drew, folded.
[[nodiscard]] std::string label_table(const RunResult& result);

}  // namespace rayproof
