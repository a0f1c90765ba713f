#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "properties/report/summary.hpp"

namespace rayproof {

/// Draws a case with its exact and its claimed answer as one `<svg>` element.
using DrawCase = std::function<std::string(const Case& one, const Answer* exact, const Answer* claimed)>;

/// What the page is made with.
struct PageTools {
  std::filesystem::path folder{};  ///< of the run's findings.jsonl, for the commands that name a finding
  DrawCase draw{};
};

/// The run as one self-contained HTML page, light and dark, printable: the table of subjects and properties
/// and what its words mean, every finding under its method with its number, its picture and the commands that
/// look into it, the worst errors of each family, the labels.
[[nodiscard]] std::string html_page(const Plan& plan, const RunResult& result, const Summary& summary,
                                    const PageTools& tools);

/// A finding as an `<article>`: its number, what is wrong in words, the picture, got beside exact, the
/// commands, and the case.
[[nodiscard]] std::string html_finding(const Finding& finding, const PageTools& tools);

}  // namespace rayproof
