#include "bench/figures/comparison.hpp"

#include <gmock/gmock.h>

#include "bench/page/comparison_table.hpp"
#include "unit/bench/rows.hpp"

namespace rayproof::report {
namespace {

using testing::HasSubstr;

/// A report of four methods, each of which takes 1, 2, 3 and 4 ns times this.
Measurements four_methods(double times) {
  Measurements figures{"a machine", "a compiler", 1000, {}};
  double ns = 1;
  for (const char* method : {"a", "b", "c", "d"}) {
    figures.rows.push_back(sphere_row(method, Arrangement::batch, "random", times * ns, 0, 0));
    figures.rows.back().passes_ns = {0.99 * times * ns, times * ns, 1.01 * times * ns};
    ns += 1;
  }
  return figures;
}

TEST(ReportComparison, OfAMachineThatIsSlowerByOneFactorFindsNothingSlower) {
  const Measurements before = four_methods(1), now = four_methods(3);
  const ReportComparison found = compare(before, now);
  EXPECT_EQ(found.rows, 4U);
  EXPECT_DOUBLE_EQ(found.machines, 3);
  EXPECT_TRUE(found.slower.empty());
  EXPECT_TRUE(found.faster.empty());
  EXPECT_TRUE(found.wronger.empty());
}

TEST(ReportComparison, FindsTheOneMethodThatGotSlowerAndTheOneThatGotFaster) {
  const Measurements before = four_methods(1);
  Measurements now = four_methods(3);
  for (double* ns : {&now.rows[1].ns_per_ray, &now.rows[1].passes_ns[0], &now.rows[1].passes_ns[1],
                     &now.rows[1].passes_ns[2]})
    *ns *= 2;
  for (double* ns : {&now.rows[3].ns_per_ray, &now.rows[3].passes_ns[0], &now.rows[3].passes_ns[1],
                     &now.rows[3].passes_ns[2]})
    *ns /= 2;
  const ReportComparison found = compare(before, now);
  ASSERT_EQ(found.slower.size(), 1U);
  EXPECT_EQ(found.slower[0].now->method, "b");
  EXPECT_DOUBLE_EQ(found.slower[0].slowdown, 2);
  ASSERT_EQ(found.faster.size(), 1U);
  EXPECT_EQ(found.faster[0].now->method, "d");
  EXPECT_THAT(comparison_in_text(found, before.machine),
              HasSubstr("Slower: 1\n  sphere/b float32 batch, random: 12 ns, "
                        "before 2 ns: 2.00 times as long\n"));
}

TEST(ReportComparison, BelievesNoTimeWhosePassesSpreadAsFar) {
  const Measurements before = four_methods(1);
  Measurements now = four_methods(1);
  now.rows[1].ns_per_ray = 4;
  now.rows[1].passes_ns = {1.9, 2, 2, 4, 4, 4, 4.1};
  EXPECT_TRUE(compare(before, now).slower.empty());
}

TEST(ReportComparison, FindsWhatIsWrongerOnTheSameCasesAlone) {
  const Measurements before = four_methods(1);
  Measurements now = four_methods(1);
  now.rows[0].accuracy.wrong_hits = 1;
  now.rows[1].accuracy.max_ulp = 2;
  now.rows[2].accuracy.wrong_hits = 7;
  now.rows[2].accuracy.cases = 5000;
  const ReportComparison found = compare(before, now);
  ASSERT_EQ(found.wronger.size(), 2U);
  EXPECT_EQ(found.wronger[0].now->method, "a");
  EXPECT_EQ(found.wronger[1].now->method, "b");
  EXPECT_EQ(found.other, 1U);
  EXPECT_THAT(comparison_in_html(found, before.machine), HasSubstr("<h3>Wronger than before: 2</h3>"));
}

TEST(ReportComparison, FindsTheSizeAtWhichACurveGotSlower) {
  Measurements before = four_methods(1), now = four_methods(1);
  for (const std::size_t size : {1, 10, 100}) {
    before.scaling.push_back(curve_row("scenes", "spheres", "list", size, 50));
    now.scaling.push_back(curve_row("scenes", "spheres", "list", size, size == 10 ? 200 : 50));
  }
  const ReportComparison found = compare(before, now);
  EXPECT_EQ(found.rows, 7U);
  ASSERT_EQ(found.slower.size(), 1U);
  EXPECT_EQ(found.slower[0].now->size, 10U);
  EXPECT_THAT(comparison_in_text(found, before.machine),
              HasSubstr("spheres/list float32 scalar, scenes 10: 200 ns"));
}

TEST(ReportComparison, WithAnOlderReportThatHasNoCurvesComparesTheRest) {
  const Measurements before = four_methods(1);
  Measurements now = four_methods(1);
  now.scaling.push_back(curve_row("scenes", "spheres", "list", 1, 50));
  EXPECT_EQ(compare(before, now).rows, 4U);
  EXPECT_EQ(compare(now, before).rows, 4U);
}

TEST(ReportComparison, OfReportsThatShareNoRowSaysSo) {
  const Measurements before = four_methods(1);
  const ReportComparison found = compare(before, {"another", "compiler", 1, {}});
  EXPECT_EQ(found.rows, 0U);
  EXPECT_THAT(comparison_in_text(found, before.machine), HasSubstr("0 rows are in both reports"));
}

}  // namespace
}  // namespace rayproof::report
