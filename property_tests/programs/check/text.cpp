#include "programs/check/text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "properties/report/findings.hpp"
#include "properties/report/guest.hpp"
#include "properties/report/report.hpp"

namespace rayproof::check {

namespace {

/// What breaks a contract, in full: first what has a counterexample.
std::string all_failures(const RunResult& result, const Summary& summary) {
  if (summary.is_success()) return "";
  std::string text = "\nFAILED\n" + text_failures(result.findings);
  for (const std::string& sentence : summary.without_counterexample()) text += sentence + "\n";
  return text;
}

/// Throws where properties were asked for that ask nothing of these methods: that is no success.
void expect_judged(const Plan& plan, const Summary& summary) {
  if (plan.settings.properties.empty() || summary.was_interrupted) return;
  for (const Row& row : summary.rows)
    for (const Cell& cell : row.cells)
      if (cell.status != ClaimStatus::unclaimed && cell.status != ClaimStatus::untested) return;
  throw std::runtime_error(
      fmt::format("nothing was judged: --property {} asks nothing of these methods in these cases",
                  fmt::join(plan.settings.properties, ",")));
}

}  // namespace

std::string text_outcome(const Options& options, const Plan& plan, const RunResult& result,
                         const Summary& summary) {
  expect_judged(plan, summary);
  std::string text = fmt::format(
      "seed {}, {}{} cases for each method, family and precision, {} corpus cases\n", plan.settings.seed,
      plan.settings.time ? "at most " : "", plan.settings.cases, result.corpus_cases);
  if (options.labels) text += text_labels(result) + "\n";
  if (plan.settings.measure_all) text += text_families(plan, result) + text_measured(summary) + "\n";
  text += text_table(summary) + all_failures(result, summary);
  if (const std::string declared = text_declared(result.findings); !declared.empty())
    text +=
        "\nFindings that the contracts declare (several numbers: the same failure in the other precision or "
        "method)\n" +
        declared;
  if (!result.findings.empty())
    text += fmt::format("\n./rayproof explain N, walk N, draw N, replay N{}: look into finding N\n",
                        from_option(options.out));
  text += fmt::format("how to read it: docs/reading-a-check.md\npage: {}/index.html\n", options.out);
  if (summary.was_interrupted)
    text += options.shard.count > 1 ? "a shard: rayproof merge judges the whole\n"
                                    : "interrupted: only what is shown was checked\n";
  return text + (!summary.is_success()     ? "NOT every contract holds\n"
                 : summary.was_interrupted ? "no contract is broken by what was checked\n"
                                           : "every contract holds\n");
}

std::string text_of_guests(const Options& options, const Plan& plan, const RunResult& result) {
  std::string text = fmt::format(
      "{}\nseed {}, {}{} cases for each shape, family and precision\n",
      options.command.empty() ? fmt::format("{}", fmt::join(options.subjects, ", ")) : options.command,
      plan.settings.seed, plan.settings.time ? "at most " : "", plan.settings.cases);
  if (!result.findings.empty()) text += "\nFINDINGS\n" + text_failures(result.findings) + "\n";
  text += text_guests(plan, result);
  if (!result.findings.empty())
    text += fmt::format("./rayproof explain N, draw N, replay N{}: look into finding N\n",
                        from_option(options.out));
  if (!result.findings.empty() && !options.subjects.empty())
    text += fmt::format("./rayproof bugreport N{}: finding N as a report to the library's makers\n",
                        from_option(options.out));
  text += fmt::format("page: {}/index.html\n", options.out);
  if (result.was_interrupted) text += "interrupted: only what is shown was checked\n";
  return text + verdict_on_guests(plan, result).sentence + "\n";
}

}  // namespace rayproof::check
