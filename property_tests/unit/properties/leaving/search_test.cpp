/// \file
/// The search for rays that meet again what they have left.

#include "properties/leaving/search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "case/reader.hpp"
#include "case/writer.hpp"
#include "oracle/oracle.hpp"
#include "properties/leaving/text.hpp"

namespace rayproof::leaving {

namespace {

const std::atomic<bool> never{false};

SearchResult searched(const SearchSettings& settings, const std::atomic<bool>& stop = never) {
  return search(settings, stop, [](double, const std::string&) {});
}

TEST(LeavingSearch, FindsNoFalseHitOfWhatIsProven) {
  const SearchResult result = searched({.cases = 1024, .strategies = {"proven"}});
  EXPECT_EQ(broken_promises(result), std::vector<std::string>{});
  EXPECT_TRUE(result.failures.empty());
  for (const StrategyOutcome& outcome : result.outcomes)
    EXPECT_GT(outcome.tally.all().rays, 3000U) << outcome.shape << ' ' << name_of(outcome.precision);
}

TEST(LeavingSearch, FindsEveryOtherStrategysFailure) {
  const SearchResult result = searched({.cases = 256, .shapes = {"box", "triangle"}});
  for (const Strategy& strategy : strategies()) {
    const auto is_its = [&](const WrongStart& one) { return one.strategy == &strategy; };
    EXPECT_EQ(std::ranges::count_if(result.failures, is_its), strategy.is_proven ? 0 : 1) << strategy.name;
  }
}

TEST(LeavingSearch, PrintsEachFailureAsACaseThatTheOracleHits) {
  for (const WrongStart& failure : searched({.cases = 64, .shapes = {"sphere"}}).failures) {
    const Case read = read_case(write_case(failure.left));
    EXPECT_EQ(write_case(read), write_case(failure.left));
    EXPECT_GT(std::get<RayAnswer>(oracle::answer(read)).hits.count, 0U) << write_case(read);
  }
}

TEST(LeavingSearch, ComesToTheSameWithAnyNumberOfJobs) {
  SearchSettings one{.cases = 300, .jobs = 1, .shapes = {"cylinder"}}, three = one;
  three.jobs = 3;
  const SearchResult first = searched(one), second = searched(three);
  EXPECT_EQ(text_table(first) + text_shapes(first) + text_failures(first),
            text_table(second) + text_shapes(second) + text_failures(second));
  EXPECT_EQ(json_text(one, first), json_text(one, second));
}

TEST(LeavingSearch, ComparesOffsetsOnlyWhereTheRuleItselfWorks) {
  const SearchResult result =
      searched({.cases = 256, .shapes = {"sphere"}, .strategies = {"fixed", "proven"}});
  for (const StrategyOutcome& outcome : result.outcomes) {
    const Count all = outcome.tally.all();
    EXPECT_EQ(all.compared, all.rays - all.false_hits - all.skipped) << outcome.strategy->name;
    EXPECT_EQ(all.tenfold > 0, !outcome.strategy->is_proven) << outcome.strategy->name;
  }
  EXPECT_NE(text_tenfold(result).find("1e-3 "), std::string::npos);
  EXPECT_EQ(text_tenfold(searched({.cases = 64, .shapes = {"sphere"}, .strategies = {"proven"}})), "");
}

TEST(LeavingSearch, KeepsWhatItHasWhenItIsStopped) {
  const std::atomic<bool> at_once{true};
  const SearchResult result = searched({.cases = 1U << 20U}, at_once);
  EXPECT_TRUE(result.was_interrupted);
  EXPECT_TRUE(broken_promises(result).empty());
}

TEST(LeavingSearch, NamesWhatItDoesNotKnow) {
  EXPECT_NE(unknown_names({.shapes = {"torus"}}).find("torus"), std::string::npos);
  EXPECT_NE(unknown_names({.strategies = {"hope"}}).find("proven"), std::string::npos);
  EXPECT_EQ(unknown_names({.shapes = {"box"}, .strategies = {"fixed"}}), "");
}

/// A strategy that is wrong on purpose: it stays where it is, and says that it is proven.
TEST(LeavingSearch, NoticesABrokenPromise) {
  SearchResult result = searched({.cases = 64, .shapes = {"sphere"}, .strategies = {"nothing"}});
  Strategy liar = *result.outcomes.front().strategy;
  liar.is_proven = true;
  for (StrategyOutcome& outcome : result.outcomes) outcome.strategy = &liar;
  EXPECT_EQ(broken_promises(result).size(), 2U);
}

TEST(LeavingSearch, ShowsWhatAProvenStrategySkips) {
  const SearchSettings settings;
  Strategy liar = *std::ranges::find(strategies(), "fixed", &Strategy::name);
  liar.is_proven = true;
  for (std::uint64_t number = 0; number < 2000; ++number) {
    const Situation from = situation_number(settings, "box", Precision::float32, number);
    if (depart(liar, from, liar.origin(from)) != oracle::Departure::skipped) continue;
    const WrongStart shown = simplest(liar, from, never);
    EXPECT_NE(shown.left.note.find("starts outside of the solid"), std::string::npos) << shown.left.note;
    EXPECT_EQ(std::get<RayAnswer>(oracle::answer(shown.left)).hits.count, 0U) << write_case(shown.left);
    return;
  }
  FAIL() << "nothing is skipped";
}

/// A strategy that is wrong on purpose: it starts nowhere.
TEST(LeavingSearch, CountsARayWithoutAnOriginAsAFailure) {
  Strategy lost = *std::ranges::find(strategies(), "fixed", &Strategy::name);
  lost.origin = [](const Situation&) { return glm::dvec3(std::numeric_limits<double>::quiet_NaN()); };
  Situation from = situation_number({}, "cylinder", Precision::float32, 1);
  EXPECT_EQ(depart(lost, from, lost.origin(from)), oracle::Departure::no_origin);
  EXPECT_TRUE(is_failure(lost, oracle::Departure::no_origin));
  const WrongStart shown = simplest(lost, from, never);
  EXPECT_TRUE(shown.left.note.ends_with("starts nowhere")) << shown.left.note;
  from.has_normal = false;  // as a solid's whose normal is NaN
  const Strategy& nothing = *std::ranges::find(strategies(), "nothing", &Strategy::name);
  EXPECT_EQ(depart(nothing, from, nothing.origin(from)), oracle::Departure::no_origin);
}

TEST(ASituation, IsLeftToEitherSide) {
  const SearchSettings settings;
  int back = 0;
  for (std::uint64_t number = 0; number < 200; ++number)
    back += situation_number(settings, "box", Precision::float32, number).what.side == spawn::Side::back;
  EXPECT_GT(back, 50);
  EXPECT_LT(back, 150);
}

TEST(ASituation, OfEachShapeComesInEveryDecadeOfSize) {
  const SearchResult result = searched({.cases = 2048, .strategies = {"nothing"}});
  for (const StrategyOutcome& outcome : result.outcomes)
    for (int decade = -5; decade < 6; ++decade)
      EXPECT_GT(outcome.tally.by_size.at(static_cast<std::size_t>(decade - least_decade)).rays, 10U)
          << outcome.shape << ' ' << decade;
}

}  // namespace

}  // namespace rayproof::leaving
