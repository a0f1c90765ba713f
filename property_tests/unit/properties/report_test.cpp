#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "case/escape.hpp"
#include "case/reader.hpp"
#include "case/writer.hpp"
#include "properties/report/findings.hpp"
#include "properties/report/grid.hpp"
#include "properties/report/report.hpp"
#include "subjects/subject.hpp"
#include "unit/properties/broken_subjects.hpp"
#include "unit/properties/well_formed.hpp"

namespace rayproof {
namespace {

/// A short run of a subject that breaks its residual, with a title full of what XML must escape.
struct ShortRun {
  std::vector<Subject> all{broken::subject("sphere", [](const Case& one) {
    return broken::changed_hits(one, [](double t) { return 2 * t + 1; });
  })};
  Plan plan;
  RunResult result;
  Summary summary;

  ShortRun() {
    all[0].title = "a < b && \"c\" > 'd'";
    all[0].name = "on<purpose>&";
    Settings settings;
    settings.cases = 500;
    settings.families = {"random"};
    plan = make_plan(settings, all);
    const std::atomic<bool> is_interrupted{false};
    result = run_plan(plan, {}, {}, is_interrupted);
    summary = summarise(plan, result);
  }
};

std::string no_picture(const Case&, const Answer*, const Answer*) { return "<svg></svg>"; }

TEST(Report, TheJUnitFileIsWellFormedAndCountsItsFailures) {
  const ShortRun run;
  const std::string xml = junit_report(run.summary, run.result);
  EXPECT_EQ(why_not_well_formed(xml), "");
  std::size_t failures = 0;
  for (std::size_t at = xml.find("<failure"); at != std::string::npos; at = xml.find("<failure", at + 1))
    ++failures;
  EXPECT_EQ(failures, run.summary.failures().size());
  EXPECT_GT(failures, 0U);
}

TEST(Report, ThePageIsWellFormedAndSpeaksToNobodyElse) {
  const ShortRun run;
  const std::string page = html_page(run.plan, run.result, run.summary, {"out/check", no_picture});
  EXPECT_EQ(why_not_well_formed(page), "");
  EXPECT_EQ(page.find("http"), std::string::npos);
  EXPECT_EQ(page.find("src="), std::string::npos);
  EXPECT_NE(page.find("prefers-color-scheme: dark"), std::string::npos);
}

TEST(Report, ThePageHoldsEveryCounterexample) {
  const ShortRun run;
  const std::string page = html_page(run.plan, run.result, run.summary, {"out/check", no_picture});
  ASSERT_FALSE(run.result.findings.empty());
  for (const Finding& finding : run.result.findings)
    EXPECT_NE(page.find(escaped(finding.evidence.note)), std::string::npos);
}

TEST(Report, TheJsonReportCanBeReadAndSaysWhetherItFailed) {
  const ShortRun run;
  const auto json = nlohmann::json::parse(json_report(run.plan, run.result, run.summary));
  EXPECT_EQ(json.at("success"), false);
  EXPECT_EQ(json.at("findings").size(), run.result.findings.size());
  EXPECT_EQ(json.at("methods").size(), 2U);
}

TEST(Report, TheTableHasOneLineForBothPrecisionsOfAMethod) {
  const ShortRun run;
  const std::string table = text_table(run.summary);
  const std::size_t line = table.find("sphere/on<purpose>&");
  ASSERT_NE(line, std::string::npos);
  EXPECT_EQ(table.find("sphere/on<purpose>&", line + 1), std::string::npos);
  EXPECT_NE(table.find("✗"), std::string::npos);
  EXPECT_NE(
      table.find(fmt::format("0 of {}", run.summary.rows[0].worst.cases + run.summary.rows[1].worst.cases)),
      std::string::npos)
      << table;
}

TEST(Report, WhereThePrecisionsDifferTheTableHasAMarkForEach) {
  ShortRun run;
  for (Cell& cell : run.summary.rows[1].cells)
    if (cell.status == ClaimStatus::broken) cell.status = ClaimStatus::holds;
  EXPECT_NE(text_table(run.summary).find("✗✓"), std::string::npos);
}

TEST(Report, TheTablesHeadsAreTheClaimsNamesInShortLines) {
  for (std::size_t c = 0; c < claim_count; ++c) {
    std::string name;
    for (const std::string_view line : head_of(static_cast<Claim>(c))) {
      EXPECT_LE(line.size(), 5U);
      name += line.substr(0, line.find('-'));
    }
    EXPECT_EQ(name, claim_names.at(c));
    EXPECT_EQ(head_of(static_cast<Claim>(c)).back().find('-'), std::string_view::npos);
  }
}

TEST(Report, TheTableOfAllMethodsFitsHundredAndTwentyColumns) {
  Summary summary = summarise(make_plan({}), {});
  for (Row& row : summary.rows) row.worst = {.wrong = 26841, .cases = 103584};
  std::istringstream lines(text_table(summary));
  for (std::string line; std::getline(lines, line);)
    EXPECT_LE(std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; }), 120) << line;
}

TEST(Report, FailuresStandFirstAndInFull) {
  ShortRun run;
  run.result.findings.push_back(run.result.findings.front());
  run.result.findings.front().is_declared = true;
  put_in_order(run.result.findings);
  ASSERT_GE(run.result.findings.size(), 2U);
  EXPECT_FALSE(run.result.findings.front().is_declared);
  EXPECT_TRUE(run.result.findings.back().is_declared);
  for (std::size_t i = 0; i < run.result.findings.size(); ++i)
    EXPECT_EQ(run.result.findings[i].number, i + 1);
  const std::string text = text_failures(run.result.findings);
  EXPECT_NE(text.find(write_case(run.result.findings.front().one)), std::string::npos);
  EXPECT_NE(text.find(run.result.findings.front().evidence.note), std::string::npos);
}

TEST(Report, AMethodThatFailsOnManyCasesFailsInOneBlock) {
  ShortRun run;
  const Finding failure = run.result.findings.front();
  run.result.findings.assign(50, failure);
  put_in_order(run.result.findings);
  const std::string text = text_failures(run.result.findings);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5) << text;
  EXPECT_NE(text.find(" 1-50  sphere/"), std::string::npos) << text;
}

TEST(Report, ThePageSaysEachCommandWithTheRunItBelongsTo) {
  ShortRun run;
  put_in_order(run.result.findings);
  const std::string usual = html_page(run.plan, run.result, run.summary, {"out/check", no_picture});
  EXPECT_NE(usual.find("./rayproof explain 1\n"), std::string::npos);
  const std::string other = html_page(run.plan, run.result, run.summary, {"out/my run", no_picture});
  EXPECT_NE(other.find("./rayproof explain 1 --from &#39;out/my run/findings.jsonl&#39;\n"),
            std::string::npos);
}

TEST(Report, ThePageSaysTheDiagnosisAndTheExactAnswerInTheirPlaces) {
  ShortRun run;
  run.result.findings.resize(1);
  run.result.findings[0].diagnosis = "right as soon as a < b";
  const std::string page = html_page(run.plan, run.result, run.summary, {"out/check", no_picture});
  EXPECT_NE(page.find("<dl><dt>Diagnosis</dt>"), std::string::npos);
  EXPECT_NE(page.find("right as soon as a &lt; b"), std::string::npos);
  EXPECT_NE(page.find("\nexact {&quot;verdict&quot;"), std::string::npos);
}

TEST(Report, ThePageShowsWhatIsBrokenBeforeWhatWasAsked) {
  const ShortRun run;
  const std::string page = html_page(run.plan, run.result, run.summary, {"out/check", no_picture});
  const std::size_t finding = page.find("<article"), table = page.find("<th class=\"claim\"");
  ASSERT_NE(table, std::string::npos);
  EXPECT_LT(finding, table);
}

TEST(Report, ThePageHasNoColumnForAPropertyThatNoMethodSpeaksOf) {
  const ShortRun run;
  const std::string page = html_page(run.plan, run.result, run.summary, {"out/check", no_picture});
  const std::vector<Cell>& cells = run.summary.rows.front().cells;
  std::size_t unclaimed = 0;
  for (const Cell& cell : cells) {
    const bool is_claimed = cell.status != ClaimStatus::unclaimed;
    const std::string head = fmt::format("<span>{}</span></th>", cell.property->name);
    EXPECT_EQ(page.find(head) != std::string::npos, is_claimed) << head;
    unclaimed += is_claimed ? 0 : 1;
  }
  EXPECT_GT(unclaimed, 0U);
  EXPECT_LT(unclaimed, cells.size());
}

TEST(Report, ThePageSaysWhatItsWordsMean) {
  const ShortRun run;
  const std::string page = html_page(run.plan, run.result, run.summary, {"out/check", no_picture});
  for (const char* word : {"verdict", "residual", "ulp", "contract unit", "verdict band", "robust", "domain",
                           "far_power", "sound, naive, printed"})
    EXPECT_NE(page.find(fmt::format("<dt>{}</dt>", word)), std::string::npos) << word;
}

/// A finding of `method` on a case, as a run would report it.
Finding finding_of(const char* method, const char* property, const char* text) {
  Finding finding;
  finding.number = 12;
  finding.subject = find_subject(method);
  finding.property = find_property(property);
  finding.one = read_case(text);
  Trial trial(*finding.subject, finding.one);
  finding.evidence = finding.property->show(trial);
  return finding;
}

TEST(Words, SayWhatTheMethodDoesAndWhatIsExact) {
  EXPECT_EQ(
      text_finding(finding_of(
          "sphere/textbook", "robust-verdict",
          R"({"precision": "float32", "ray": {"origin": [0, 0.2, -4499.9], "direction": [0, 0, 9]}, "shape": {"type": "sphere", "center": [0, 0, 0], "radius": 1}})")),
      "   12  sphere/textbook float32  misses a sphere of radius 1 from 4500 away (exact 499.88, "
      "500.09775)\n");
  EXPECT_EQ(
      in_words(finding_of("quadratic/textbook", "robust-residual",
                          R"({"precision": "float32", "query": "quadratic", "a": 1, "b": 70, "c": 1})")),
      "solves x² + 70x + 1 by x = -0.014289856 (exact -0.014288631)");
  EXPECT_EQ(
      in_words(finding_of("quadratic/textbook", "verdict",
                          R"({"precision": "float32", "query": "quadratic", "a": 0, "b": -1, "c": 0})")),
      "finds no root of -x (exact 0)");
  EXPECT_EQ(in_words(finding_of(
                "point_in_polygon/printed_parity", "robust-verdict",
                R"({"query": "point_in_polygon", "point": [0, 0], "vertices": [[0, 1], [1, 0], [1, -1]]})")),
            "says 'inside' of (0, 0) and a polygon with 3 vertices (exact outside)");
  EXPECT_EQ(
      in_words(finding_of(
          "plane/printed_parallel", "contact",
          R"({"ray": {"origin": [0, 0, 0], "direction": [0, 1, 0]}, "shape": {"type": "plane", "point": [0, 0, 0], "u": [0, 1, 0], "v": [1, 0, 0]}})")),
      "calls the miss of a plane 'parallel' (exact 'in_surface')");
  EXPECT_EQ(
      in_words(finding_of(
          "sphere/printed_2ac", "scaled",
          R"({"ray": {"origin": [0, 0, 0], "direction": [0, 0, 1]}, "shape": {"type": "sphere", "center": [0, 0, 0], "radius": 1}})")),
      "hits a sphere of radius 1 at t = 1, but 0.25 once scaled (exact 1)");
}

TEST(Report, ColumnsLineUpUnderWideSigns) {
  EXPECT_EQ(in_columns({{"a", "b"}, {"✓✓✓", "x"}}), "a    b\n------\n✓✓✓  x\n");
  EXPECT_EQ(in_columns({{"", "b"}, {"✓✓✓", ""}}, 1, false), "    b\n✓✓✓\n");
}

TEST(Report, FiguresAreShort) {
  EXPECT_EQ(figure(0), "0");
  EXPECT_EQ(figure(0.93345), "0.933");
  EXPECT_EQ(figure(123456), "1.2e+05");
  EXPECT_EQ(figure(HUGE_VAL), "inf");
  EXPECT_EQ(figure(0.5, 8), "0.5 of 8");
  EXPECT_EQ(figure(0.5, HUGE_VAL), "0.5");
}

TEST(Escape, LeavesNoMarkupAndNoControlCharacters) {
  EXPECT_EQ(escaped("<a href='x'>\"&\"\x01</a>"), "&lt;a href=&#39;x&#39;&gt;&quot;&amp;&quot;?&lt;/a&gt;");
}

}  // namespace
}  // namespace rayproof
