#include "properties/report/exports.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "case/escape.hpp"

namespace rayproof {

namespace {

/// What explains a failed cell: the finding, or the want of one.
std::string explanation(const RunResult& result, const Row& row, const Cell& cell) {
  for (const Finding& finding : result.findings)
    if (finding.subject == row.subject && finding.property == cell.property &&
        finding.one.precision == row.precision)
      return write_finding(finding);
  return "no counterexample was found";
}

struct Suite {
  std::string tests{};
  unsigned count = 0;
  unsigned failures = 0;
  unsigned skipped = 0;

  void add(const std::string& name, const std::string& inside = {}) {
    ++count;
    tests += fmt::format("    <testcase name=\"{}\">{}</testcase>\n", escaped(name), inside);
  }
  void fail(const std::string& name, const char* message, const std::string& text) {
    ++failures;
    add(name, fmt::format("<failure message=\"{}\">{}</failure>", escaped(message), escaped(text)));
  }
  void skip(const std::string& name) {
    ++skipped;
    add(name, "<skipped/>");
  }

  [[nodiscard]] std::string text(const std::string& name) const {
    return fmt::format(
        "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\">\n{}  "
        "</testsuite>\n",
        escaped(name), count, failures, skipped, tests);
  }
};

void add_cell(Suite& suite, const RunResult& result, const Row& row, const Cell& cell) {
  const std::string name = fmt::format("{}: {}", cell.property->name, cell.property->statement);
  if (is_failure(cell.status))
    suite.fail(name, text_of(cell.status).words, explanation(result, row, cell));
  else if (cell.status == ClaimStatus::untested)
    suite.skip(name);
  else if (cell.status != ClaimStatus::unclaimed)
    suite.add(name);
}

Suite shares_suite(const RunResult& result) {
  Suite suite;
  for (const LabelCount& labels : result.labels) {
    const std::string name = fmt::format("{}/{} {} produces what it is for", labels.family->topic,
                                         labels.family->name, name_of(labels.precision));
    const std::vector<std::string> missed = labels.missed();
    missed.empty() ? suite.add(name) : suite.fail(name, "share missed", missed.front());
  }
  return suite;
}

}  // namespace

std::string junit_report(const Summary& summary, const RunResult& result) {
  std::string suites;
  for (const Row& row : summary.rows) {
    Suite suite;
    for (const Cell& cell : row.cells) add_cell(suite, result, row, cell);
    suites += suite.text(fmt::format("{} {}", row.subject->full_name(), name_of(row.precision)));
  }
  suites += shares_suite(result).text("generators");
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"rayproof check\">\n" + suites +
         "</testsuites>\n";
}

}  // namespace rayproof
