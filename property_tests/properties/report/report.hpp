#pragma once
/// \file
/// A run as plain text, as a page, and as other programs read it.

#include <array>
#include <filesystem>
#include <functional>
#include <string>

#include "properties/report/summary.hpp"

namespace rayproof {

/// One line for each method with a mark for each claim, both precisions together (two marks, float32 first,
/// where they differ), and its wrong verdicts among the cases of its domain; under it what the marks mean. No
/// line is wider than 120 columns.
[[nodiscard]] std::string text_table(const Summary& summary);

/// A claim's name in up to three short lines, the last ones filled: "re-", "si-", "dual". So the table fits
/// 120 columns.
[[nodiscard]] std::array<std::string_view, 3> head_of(Claim claim);

/// The worst errors of each method on each family, one table for each topic and measure.
[[nodiscard]] std::string text_families(const Plan& plan, const RunResult& result);

/// What the generators produced, family by family.
[[nodiscard]] std::string text_labels(const RunResult& result);

/// The worst figures as the contracts write them, ready to be copied.
[[nodiscard]] std::string text_measured(const Summary& summary);

/// All figures of a run as one JSON object: `seed`, `cases`, `success`, `failures`, `methods` (each with its
/// properties, marks, counts and worst errors), `families` (the worst errors of each method on each),
/// `labels`, `findings`. Errors that are not finite are the strings of the case format.
[[nodiscard]] std::string json_report(const Plan& plan, const RunResult& result, const Summary& summary);

/// The outcome as JUnit XML: a suite for each method and precision, a test for each property it claims or is
/// declared to break, and a suite for the generators' shares.
[[nodiscard]] std::string junit_report(const Summary& summary, const RunResult& result);

/// What the page is made with.
struct PageTools {
  std::filesystem::path folder{};  ///< of the run's findings.jsonl, for the commands that name a finding
  /// Draws a case with its exact and its claimed answer as one element of HTML.
  std::function<std::string(const Case& one, const Answer* exact, const Answer* claimed)> draw{};
  std::string style{};   ///< what the pictures need
  std::string script{};  ///< the address of their script, beside the page; empty for none
};

/// The run as an HTML page that needs nothing but the pictures' script beside it, light and dark, printable:
/// the table of subjects and properties and what its words mean, every finding under its method with its
/// number, its picture and the commands that look into it, the worst errors of each family, the labels.
[[nodiscard]] std::string html_page(const Plan& plan, const RunResult& result, const Summary& summary,
                                    const PageTools& tools);

/// A finding as an `<article>`: its number, what is wrong in words, the picture, got beside exact, the
/// commands, and the case.
[[nodiscard]] std::string html_finding(const Finding& finding, const PageTools& tools);

}  // namespace rayproof
