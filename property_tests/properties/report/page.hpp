#pragma once
#include <functional>
#include <string>

#include "properties/report/summary.hpp"

namespace rayproof {

/// Draws a case with its exact and its claimed answer as one `<svg>` element.
using DrawCase = std::function<std::string(const Case& one, const Answer* exact, const Answer* claimed)>;

/// The run as one self-contained HTML page, light and dark, printable: the table of subjects and properties,
/// every counterexample with its picture and the commands that look into it, the worst errors of each family,
/// the labels.
[[nodiscard]] std::string html_page(const Plan& plan, const RunResult& result, const Summary& summary,
                                    const DrawCase& draw);

}  // namespace rayproof
