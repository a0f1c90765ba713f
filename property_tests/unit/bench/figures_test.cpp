#include <gtest/gtest.h>

#include <cmath>

#include "bench/figures/accuracy.hpp"
#include "bench/page/plot.hpp"
#include "bench/page/plot_svg.hpp"
#include "bench/peers/peer.hpp"
#include "generators/generators.hpp"
#include "oracle/oracle.hpp"
#include "unit/bench/rows.hpp"

namespace rayproof::report {

namespace {

Case unit_sphere_from(double z) {
  Case one;
  one.precision = Precision::float32;
  one.question = RayQuestion{{{0, 0, z}, {0, 0, 1}}, Sphere<double>{{0, 0, 0}, 1}};
  return one;
}

JudgedFamily two_cases() {
  RayAnswer hit;
  hit.contact = Contact::crossing;
  hit.hits.push_back(4);
  hit.hits.push_back(6);
  return {{unit_sphere_from(-5), unit_sphere_from(5)}, {hit, RayAnswer{}}};
}

/// A subject that answers every case with hits at 4 and `second`.
template <int second>
Answer always(const Case& /*one*/) {
  RayAnswer answer;
  answer.hits.push_back(4);
  answer.hits.push_back(second == 6 ? static_cast<double>(std::nextafter(6.0F, 7.0F)) : second);
  return answer;
}

Accuracies measured(const Subject& subject) {
  const Subject* one = &subject;
  return measure({&one, 1}, two_cases()).at(0);
}

TEST(Accuracy, CountsAHitTooManyAndAveragesOnlyTheHitsThatAreAgreedOn) {
  Subject subject;
  subject.answer_by(always<6>);
  const Accuracy found = measured(subject).scalar;
  EXPECT_EQ(found.cases, 2U);
  EXPECT_EQ(found.wrong_hits, 1U);
  EXPECT_EQ(found.wrong_misses, 0U);
  EXPECT_EQ(found.agreed_hits, 2U);
  EXPECT_NEAR(found.max_ulp, 1, 1e-6);
  EXPECT_DOUBLE_EQ(found.mean_bits, 0.5);  // one hit is right to the last bit, the other is the next float
}

TEST(Accuracy, IsThatOfEachSubjectHoweverManyAreJudgedTogether) {
  Subject wrong, right;
  wrong.answer_by(always<6>);
  right.answer_by([](const Case& one) { return oracle::answer(one); });
  const Subject* all[] = {&wrong, &right, &wrong};
  const std::vector<Accuracies> found = measure(all, two_cases());
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].scalar.wrong_hits, 1U);
  EXPECT_EQ(found[1].scalar.wrong_hits, 0U);
  EXPECT_EQ(found[1].scalar.max_ulp, 0);
  EXPECT_EQ(found[2].scalar.wrong_hits, 1U);
}

TEST(Accuracy, CountsAHitTooFew) {
  Subject subject;
  subject.answer_by([](const Case&) { return Answer(RayAnswer{}); });
  const Accuracy found = measured(subject).scalar;
  EXPECT_EQ(found.wrong_misses, 1U);
  EXPECT_EQ(found.wrong_hits, 0U);
  EXPECT_TRUE(std::isnan(found.mean_bits));
}

TEST(Summary, LeavesOutTheFamiliesThatAreNotOfScenesAndSumsUpTheOthers) {
  const std::vector<MethodSummary> found =
      summarise({sphere_row("centred", Arrangement::batch, "random", 1, 10, 2),
                 sphere_row("centred", Arrangement::batch, "far", 3, 30, 4),
                 sphere_row("centred", Arrangement::batch, "bit_patterns", 90, 900, 20)});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_DOUBLE_EQ(found[0].wrong_share(), 0.02);
  EXPECT_DOUBLE_EQ(found[0].accuracy.mean_bits, 3);
}

TEST(Headline, IsLeftOutWhereGlmWasNotMeasured) {
  const std::vector<BenchRow> rows{sphere_row("centred", Arrangement::batch, "random", 1, 0, 0),
                                   sphere_row(floor_name, Arrangement::batch, "random", 0.5, 0, 0)};
  EXPECT_FALSE(headline(rows).has_value());
}

TEST(Plot, HasAFrontOfThePointsThatNoOtherBeats) {
  const std::vector<Plot> plots =
      make_plots(summarise({sphere_row("fast", Arrangement::batch, "random", 1, 0, 8),
                            sphere_row("beaten", Arrangement::batch, "random", 10, 0, 9),
                            sphere_row("exact", Arrangement::batch, "random", 100, 0, 0)}));
  ASSERT_EQ(plots.size(), 1U);
  const auto& front = plots[0].panels.back().front;
  const std::vector<std::pair<double, double>> stair{{0, 8}, {2, 8}, {2, 0}};
  EXPECT_EQ(front, stair);
}

TEST(Plot, DistinguishesAnyTwoMethodsWithoutColour) {
  std::vector<BenchRow> rows;
  for (const char* method : {"a", "b", "c", "d", "e", "f", "g", "h", "i"})
    rows.push_back(sphere_row(method, Arrangement::batch, "random", 1, 0, 1));
  const std::vector<PlotMark> marks = make_plots(summarise(rows)).at(0).marks;
  for (std::size_t i = 0; i < marks.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE(marks[i].outline == marks[j].outline && marks[i].inner == marks[j].inner) << i << ' ' << j;
}

TEST(PlotInSvg, NamesOtherLibrariesAtTheirMarksAndTheOracleAtItsLine) {
  const std::string svg =
      to_svg(make_plots(summarise({sphere_row("centred", Arrangement::batch, "random", 1, 0, 1),
                                   sphere_row("glm", Arrangement::scalar, "random", 9, 3, 1),
                                   sphere_row(oracle_name, Arrangement::scalar, "random", 150, 0, 0)}))
                 .at(0));
  const auto count = [&](const std::string& words) {
    std::size_t found = 0;
    for (std::size_t at = svg.find(words); at != std::string::npos; at = svg.find(words, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count(">glm</text>"), 2U) << "in each of the two charts, and in no legend";
  EXPECT_EQ(count(">oracle</text>"), 2U);
  EXPECT_EQ(count(">streaming</text>"), 1U) << "the floor was not measured: in the legend alone";
}

TEST(PlotInSvg, HasRoomForTheLongestNameOfAMethod) {
  const std::string name = "printed_unit_direction_and_more";
  const std::string svg =
      to_svg(make_plots(summarise({sphere_row(name.c_str(), Arrangement::batch, "random", 1, 0, 1)})).at(0));
  const double width = std::stod(svg.substr(svg.find("viewBox=\"0 0 ") + 13));
  const std::size_t text = svg.rfind("<text x=\"", svg.find(">" + name + "<"));
  ASSERT_NE(text, std::string::npos);
  EXPECT_GE(width, std::stod(svg.substr(text + 9)) + 8.5 * static_cast<double>(name.size()));
}

TEST(Contenders, CoverEveryMethodInItsArrangementsAndTheFloorOfBatches) {
  for (const Family& family : families()) {
    if (family.name != "random") continue;
    std::vector<Case> cases;
    for (std::uint64_t seed = 0; seed < 64; ++seed)
      cases.push_back(family.generate(seed, Precision::float32));
    std::vector<Contender> all = contenders(family.topic, cases, Precision::float32);
    const bool has_batches = std::ranges::count(all, Arrangement::batch, &Contender::arrangement) > 0;
    EXPECT_EQ(all.back().method == floor_name, has_batches);
    std::ranges::move(peer_contenders(family.topic, cases, Precision::float32), std::back_inserter(all));
    for (const auto& passes : time_passes(all, cases.size(), 0.001)) {
      EXPECT_GE(passes.size(), 5U);
      for (const double ns : passes) EXPECT_GT(ns, 0);
    }
    for (const Subject& subject : subjects()) {
      if (subject.topic != family.topic) continue;
      const auto own = std::ranges::count(all, subject.name, &Contender::method);
      EXPECT_EQ(own, subject.answer_in_batch == nullptr ? 1 : 2) << subject.full_name();
    }
  }
}

}  // namespace

}  // namespace rayproof::report
