#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "properties/report/escape.hpp"
#include "properties/report/grid.hpp"
#include "properties/report/json.hpp"
#include "properties/report/junit.hpp"
#include "properties/report/page.hpp"
#include "properties/report/text.hpp"
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
  const std::string page = html_page(run.plan, run.result, run.summary, no_picture);
  EXPECT_EQ(why_not_well_formed(page), "");
  EXPECT_EQ(page.find("http"), std::string::npos);
  EXPECT_EQ(page.find("src="), std::string::npos);
  EXPECT_NE(page.find("prefers-color-scheme: dark"), std::string::npos);
}

TEST(Report, ThePageHoldsEveryCounterexample) {
  const ShortRun run;
  const std::string page = html_page(run.plan, run.result, run.summary, no_picture);
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

TEST(Report, TheTableHasALineForEachMethodAndPrecision) {
  const ShortRun run;
  const std::string table = text_table(run.summary);
  EXPECT_NE(table.find("sphere/on<purpose>&  float32"), std::string::npos);
  EXPECT_NE(table.find("sphere/on<purpose>&  float64"), std::string::npos);
  EXPECT_NE(table.find("✗"), std::string::npos);
}

TEST(Report, ColumnsLineUpUnderWideSigns) {
  Grid grid;
  grid.add({"a", "b"});
  grid.add({"✓✓✓", "x"});
  EXPECT_EQ(grid.text(), "a    b\n------\n✓✓✓  x\n");
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
