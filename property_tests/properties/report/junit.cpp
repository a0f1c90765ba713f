#include "properties/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "case/escape.hpp"

namespace rayproof {

namespace {

struct Test {
  std::string name{};
  std::string outcome{};  ///< an element that says how it failed, or that it was skipped; empty if it passed
};

std::string failure(const char* message, const std::string& text) {
  return fmt::format("<failure message=\"{}\">{}</failure>", escaped(message), escaped(text));
}

std::string suite(const std::string& name, const std::vector<Test>& tests) {
  const auto count = [&](std::string_view element) {
    return std::ranges::count_if(tests, [&](const Test& one) { return one.outcome.starts_with(element); });
  };
  std::string text =
      fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\">\n",
                  escaped(name), tests.size(), count("<failure"), count("<skipped"));
  for (const Test& one : tests)
    text += fmt::format("    <testcase name=\"{}\">{}</testcase>\n", escaped(one.name), one.outcome);
  return text + "  </testsuite>\n";
}

/// How a test of the row went.
std::string outcome_of(const RunResult& result, const Row& row, const Cell& cell) {
  if (cell.status == ClaimStatus::untested) return "<skipped/>";
  if (!is_failure(cell.status)) return "";
  const Finding* const finding = find_finding(result, row, *cell.property);
  return failure(text_of(cell.status).words,
                 finding != nullptr ? write_finding(*finding) : "no counterexample was found");
}

}  // namespace

std::string junit_report(const Summary& summary, const RunResult& result) {
  std::string suites;
  for (const Row& row : summary.rows) {
    std::vector<Test> tests;
    for (const Cell& cell : row.cells)
      if (cell.status != ClaimStatus::unclaimed)
        tests.push_back({fmt::format("{}: {}", cell.property->name, cell.property->statement),
                         outcome_of(result, row, cell)});
    suites += suite(fmt::format("{} {}", row.subject->full_name(), name_of(row.precision)), tests);
  }
  std::vector<Test> shares;
  for (const LabelCount& labels : result.labels) {
    const std::vector<std::string> missed = labels.missed();
    shares.push_back({fmt::format("{}/{} {} produces what it is for", labels.family->topic,
                                  labels.family->name, name_of(labels.precision)),
                      missed.empty() ? "" : failure("share missed", missed.front())});
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"rayproof check\">\n" + suites +
         suite("generators", shares) + "</testsuites>\n";
}

}  // namespace rayproof
