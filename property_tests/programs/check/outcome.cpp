#include "programs/check/outcome.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "properties/report/commands.hpp"
#include "properties/report/text.hpp"

namespace rayproof::check {

namespace {

/// Failures in full, first those with a counterexample.
std::string all_failures(const RunResult& result, const Summary& summary) {
  if (summary.is_success()) return "";
  std::string text = "\nFAILED\n" + text_failures(result);
  for (const std::string& sentence : summary.without_counterexample()) text += sentence + "\n";
  return text;
}

std::string last_line(const Summary& summary) {
  if (!summary.is_success()) return "NOT every contract holds";
  return summary.was_interrupted ? "no contract is broken by what was checked before the interrupt"
                                 : "every contract holds";
}

}  // namespace

std::string text_outcome(const Options& options, const Plan& plan, const RunResult& result,
                         const Summary& summary) {
  std::string text = fmt::format(
      "seed {}, {}{} cases for each method, family and precision, {} corpus cases\n", options.settings.seed,
      options.settings.time ? "at most " : "", options.settings.cases, result.corpus_cases);
  if (options.labels) text += text_labels(result) + "\n";
  if (options.measure) text += text_families(plan, result) + text_measured(summary) + "\n";
  text += text_table(summary) + all_failures(result, summary);
  if (const std::string declared = text_declared(result); !declared.empty())
    text +=
        "\nFindings that the contracts declare (several numbers: the same failure in the other precision or "
        "method)\n" +
        declared;
  if (!result.findings.empty())
    text += fmt::format("\n./rayproof explain N, walk N, draw N, replay N{}: look into finding N\n",
                        from_option(options.out));
  text += fmt::format("how to read it: docs/reading-a-check.md\npage: {}/index.html\n", options.out);
  if (summary.was_interrupted) text += "interrupted: only what is shown was checked\n";
  return text + last_line(summary) + "\n";
}

}  // namespace rayproof::check
