#include "bench/figures/curve.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <regex>
#include <set>
#include <string>

#include "bench/page/scaling_svg.hpp"
#include "unit/bench/rows.hpp"

namespace rayproof::report {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<BenchRow> scenes_of_two_sizes() {
  std::vector<BenchRow> rows;
  for (const std::size_t size : {1'000'000, 10})
    for (const char* method : {"list", "tree", "tree_in_embree", "embree", "exact_list", "exact_tree"})
      rows.push_back(curve_row("scenes", "spheres", method, size, 20 * std::log2(static_cast<double>(size))));
  return rows;
}

TEST(Curves, OfScenesHaveAChartOfPlainAndOneOfExactMethodsEachWithEmbreeAlone) {
  const std::vector<CurveChart> charts = charts_of(scenes_of_two_sizes(), "scenes");
  ASSERT_EQ(charts.size(), 2U);
  EXPECT_EQ(charts[0].title, "spheres, plain methods");
  EXPECT_EQ(charts[0].lines.size(), 4U);
  EXPECT_EQ(charts[1].title, "spheres, exact methods");
  ASSERT_EQ(charts[1].lines.size(), 3U);
  for (const CurveChart& chart : charts) {
    EXPECT_EQ(std::ranges::count(chart.lines, std::string("Embree alone"), &CurveLine::name), 1);
    for (const CurveLine& line : chart.lines) {
      ASSERT_EQ(line.points.size(), 2U);
      EXPECT_LT(line.points[0].size, line.points[1].size);
    }
  }
}

TEST(Curves, HaveTheMiddleHalfOfThePassesAboutTheMedian) {
  const CurvePoint point = charts_of({curve_row("threads", "rays", "sphere/centred", 2, 100)}, "threads")
                               .at(0)
                               .lines.at(0)
                               .points.at(0);
  EXPECT_EQ(point.ns, 100);
  EXPECT_NEAR(point.low, 95, 1e-9);
  EXPECT_NEAR(point.high, 105, 1e-9);
}

TEST(Curves, AreEmptyWhereNothingWasMeasured) {
  EXPECT_EQ(scaling_in_svg({}, "scenes"), "");
  EXPECT_EQ(scaling_in_html({}), "");
  EXPECT_EQ(scaling_in_text({}), "");
}

/// The places of all texts of a class, from left and from above.
std::vector<std::pair<double, double>> places(const std::string& svg, const std::string& style) {
  std::vector<std::pair<double, double>> found;
  const std::string end = "class=\"" + style + "\">";
  for (std::size_t at = svg.find(end); at != std::string::npos; at = svg.find(end, at + 1)) {
    const std::size_t text = svg.rfind("<text x=\"", at);
    found.emplace_back(std::stod(svg.substr(text + 9)), std::stod(svg.substr(svg.find("y=\"", text) + 3)));
  }
  return found;
}

/// No name lies on another in a plot of these.
void expect_names_apart(const std::vector<BenchRow>& rows, std::size_t count) {
  const auto names = places(scaling_in_svg(rows, "scenes"), "label");
  EXPECT_EQ(names.size(), count);
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_TRUE(names[i].first != names[j].first || std::abs(names[i].second - names[j].second) >= 18)
          << i << " and " << j;
}

TEST(CurvesInSvg, NameEachLineAtItsEndAndNoNameLiesOnAnother) {
  expect_names_apart(scenes_of_two_sizes(), 7);  // all take the same time, and their lines end in one point
}

TEST(CurvesInSvg, NameLinesThatEndEarlyApartToo) {
  std::vector<BenchRow> rows = scenes_of_two_sizes();
  std::erase_if(rows, [](const BenchRow& row) { return row.method == "list" && row.size > 10; });
  rows.push_back(curve_row("scenes", "spheres", "list", 10, 20 * std::log2(10)));
  rows.back().arrangement = Arrangement::batch;
  expect_names_apart(rows, 8);
}

TEST(CurvesInSvg, DistinguishLinesByDashesAndOutlinesToo) {
  std::vector<BenchRow> rows = scenes_of_two_sizes();
  rows.push_back(curve_row("scenes", "spheres", "list", 10, 8));
  rows.back().arrangement = Arrangement::batch;
  const std::string svg = scaling_in_svg(rows, "scenes");
  EXPECT_THAT(svg, HasSubstr("class=\"label\">list, rays in packs<"));
  for (int line = 1; line < 5; ++line)
    EXPECT_THAT(svg, HasSubstr(".l" + std::to_string(line) + " .path { stroke-dasharray"));
  std::set<std::string> outlines;  // of the marks, without where they are
  const std::regex marks("<path class=\"mark\" d=\"M[0-9.]+ [0-9.]+(m[^\"]*)\"");
  for (std::sregex_iterator mark(svg.begin(), svg.end(), marks), end; mark != end; ++mark)
    outlines.insert((*mark)[1]);
  EXPECT_EQ(outlines.size(), 5U);
  EXPECT_THAT(svg, HasSubstr("prefers-color-scheme: dark"));
}

TEST(CurvesInSvg, HaveTheSizesAndRoundTimesAtTheAxes) {
  std::vector<BenchRow> rows = scenes_of_two_sizes();
  rows.push_back(curve_row("scenes", "spheres", "list", 1'000, 200));
  const std::string svg = scaling_in_svg(rows, "scenes");
  for (const char* const tick : {">10</text>", ">1,000</text>", ">10⁶</text>", ">100</text>"})
    EXPECT_THAT(svg, HasSubstr(tick));
}

TEST(CurvesInSvg, OfOneSizeAreDrawnAllTheSame) {
  const std::string svg = scaling_in_svg({curve_row("threads", "rays", "sphere/centred", 1, 0.7)}, "threads");
  EXPECT_THAT(svg, HasSubstr("sphere/centred"));
  EXPECT_THAT(svg, Not(HasSubstr("\"nan\"")));
  EXPECT_THAT(svg, Not(HasSubstr("inf\"")));
}

TEST(CurvesInSvg, SayWhereEmbreeIsMissing) {
  const std::vector<BenchRow> ours{curve_row("scenes", "mixed", "list", 1, 50)};
  EXPECT_THAT(scaling_in_svg(ours, "scenes"), HasSubstr("Embree was not built in"));
  EXPECT_THAT(scaling_in_html(ours), HasSubstr("Embree was not built in"));
  EXPECT_THAT(scaling_in_svg(scenes_of_two_sizes(), "scenes"), Not(HasSubstr("not built in")));
  EXPECT_THAT(scaling_in_svg({curve_row("threads", "rays", "a", 1, 1)}, "threads"), Not(HasSubstr("Embree")));
}

TEST(CurvesInTables, HaveADashWhereASizeWasNotMeasured) {
  const std::vector<BenchRow> rows{curve_row("scenes", "mixed", "list", 1, 50),
                                   curve_row("scenes", "mixed", "tree", 1, 70),
                                   curve_row("scenes", "mixed", "tree", 100'000, 9000)};
  EXPECT_THAT(scaling_in_html(rows), HasSubstr("<tr><td>100000</td><td>–</td><td>9000"));
  EXPECT_THAT(scaling_in_text(rows), HasSubstr("mixed, plain methods"));
}

}  // namespace
}  // namespace rayproof::report
