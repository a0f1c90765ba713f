#include "bench/figures/choice.hpp"

#include <gmock/gmock.h>

#include "bench/page/choice_table.hpp"
#include "unit/bench/rows.hpp"

namespace rayproof::report {
namespace {

using testing::HasSubstr;

/// On one family: the exact method is expensive, the fastest is printed wrongly, another is naive.
std::vector<BenchRow> rows_on(const char* family) {
  constexpr auto batch = Arrangement::batch;
  std::vector<BenchRow> rows{sphere_row("printed_2ac", batch, family, 0.1, 500, 9),
                             sphere_row("textbook", batch, family, 0.5, 90, 5),
                             sphere_row("centred", batch, family, 1, 20, 1),
                             sphere_row("compensated", batch, family, 1.9, 5, 0.5),
                             sphere_row("rounded", batch, family, 4, 0, 0),
                             sphere_row("centred", Arrangement::scalar, family, 0.01, 0, 0)};
  return rows;
}

TEST(Choice, IsAmongSoundMethodsInBatches) {
  const std::vector<Choice> found = choose(rows_on("random"));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].scenes, Scenes::near_by);
  EXPECT_EQ(found[0].fastest.method, "centred");
  EXPECT_EQ(found[0].fastest.arrangement, Arrangement::batch);
  EXPECT_EQ(found[0].closest.method, "compensated");
  ASSERT_TRUE(found[0].exact);
  EXPECT_EQ(found[0].exact->method, "rounded");
}

TEST(Choice, IsMadeForEachKindOfScenesAndNotForNumbersOfAnySize) {
  std::vector<BenchRow> rows = rows_on("grazing");
  for (const char* family : {"far", "bit_patterns"}) {
    const std::vector<BenchRow> more = rows_on(family);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  const std::vector<Choice> found = choose(rows);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].scenes, Scenes::from_afar);
  EXPECT_EQ(found[1].scenes, Scenes::hard);
  EXPECT_EQ(choices_in_svg(found), "") << "nothing near by was measured";
}

TEST(Choice, SaysSoWhereNoMethodIsExact) {
  const std::vector<Choice> found = choose({sphere_row("centred", Arrangement::batch, "random", 1, 1, 0)});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_FALSE(found[0].exact);
  EXPECT_THAT(choices_in_text(found), HasSubstr("centred 1 ns, 0.1 % wrong"));
  EXPECT_THAT(choices_in_html(found), HasSubstr("<td>-</td>"));
}

TEST(Choice, HasTheOraclesPriceBesideTheMethods) {
  std::vector<BenchRow> rows = rows_on("random");
  EXPECT_FALSE(choose(rows).at(0).oracle_ns);
  rows.push_back(sphere_row(oracle_name, Arrangement::scalar, "random", 140, 0, 0));
  rows.push_back(sphere_row(oracle_name, Arrangement::scalar, "far", 900, 0, 0));
  const std::vector<Choice> found = choose(rows);
  ASSERT_TRUE(found.at(0).oracle_ns);
  EXPECT_EQ(*found[0].oracle_ns, 140) << "of random scenes alone";
  EXPECT_THAT(choices_in_svg(found), HasSubstr("oracle 140 ns"));
}

TEST(Choice, ANameStandsAboveItsMarkWhereTheOraclesMarkWouldLieOnIt) {
  std::vector<BenchRow> rows = rows_on("random");
  const auto name_of_exact = [&] {
    const std::string svg = choices_in_svg(choose(rows));
    const std::size_t end = svg.find("rounded ×4");
    return svg.substr(svg.rfind("<text", end), end - svg.rfind("<text", end));
  };
  EXPECT_THAT(name_of_exact(), HasSubstr("\"start\""));
  rows.push_back(sphere_row(oracle_name, Arrangement::scalar, "random", 6, 0, 0));
  EXPECT_THAT(name_of_exact(), HasSubstr("\"end\""));
  rows.back().ns_per_ray = 1e6;
  EXPECT_THAT(name_of_exact(), HasSubstr("\"start\""));
}

TEST(Choice, DistinguishesWhatIsProvenFromWhatWasFound) {
  const std::vector<Choice> found = choose(rows_on("random"));
  EXPECT_EQ(guarantee_of(*found[0].exact), "verdict exact, t rounded once: proven");
  EXPECT_THAT(guarantee_of(found[0].fastest), HasSubstr(": proven"));
  EXPECT_THAT(choices_in_svg(found), HasSubstr("rounded ×4"));
}

}  // namespace
}  // namespace rayproof::report
