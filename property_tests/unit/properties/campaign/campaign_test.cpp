/// \file
/// A campaign comes to the same however it is parted, stopped and gone on with.

#include <gtest/gtest.h>

#include "properties/campaign/run.hpp"

namespace rayproof::campaign {
namespace {

const std::atomic<bool> never{false};

Settings few(const std::string& shape = "quadratic") {
  return {.seed = 5,
          .cases = 400'000,
          .shapes = {shape},
          .methods = {"textbook"},
          .families = {"random", "whole"}};
}

CampaignState done(Shard shard, Settings settings = few(), int jobs = 2) {
  settings.jobs = jobs;
  CampaignState state = begin(settings, shard);
  run(state, {}, never);
  return state;
}

std::string trouble_with(const std::vector<CampaignState>& shards) {
  try {
    (void)merged(shards);
  } catch (const std::runtime_error& trouble) {
    return trouble.what();
  }
  return "";
}

TEST(Campaign, MergedFromItsShardsIsOneRun) {
  const CampaignState whole = done({}), again = merged({done({2, 3}), done({3, 3}), done({1, 3})});
  EXPECT_TRUE(whole.is_whole());
  EXPECT_EQ(write_state(whole), write_state(again));
  EXPECT_EQ(write_state(merged({whole})), write_state(whole));
}

TEST(Campaign, GivesEachMethodAsManyCasesAsAreAskedFor) {
  const CampaignState whole = done({});
  std::uint64_t cases = 0;
  for (const UnitState& one : whole.units) cases += one.unit.tally.cases;
  EXPECT_EQ(cases, 400'000U);
  EXPECT_EQ(whole.units.size(), 4U);
}

TEST(Campaign, IsTheSameForEveryNumberOfThreads) {
  EXPECT_EQ(write_state(done({}, few(), 1)), write_state(done({}, few(), 3)));
}

TEST(Campaign, ThatWasStoppedWithinARoundGoesOnToTheSameEnd) {
  CampaignState state = begin(few(), {});
  std::atomic<bool> stop{false};
  int blocks = 0;
  run(state, {.block = [&](const CampaignState&) { stop = ++blocks == 4 * 3 + 1; }}, stop);
  EXPECT_EQ(state.rounds, 3U);
  EXPECT_EQ(state.units_ahead, 1U);
  EXPECT_FALSE(state.is_whole());
  CampaignState later = read_state(write_state(state));
  run(later, {}, never);
  EXPECT_EQ(write_state(later), write_state(done({})));
}

TEST(Campaign, ReadsBackWhatItWrites) {
  const std::string text = write_state(done({2, 5}));
  EXPECT_EQ(write_state(read_state(text)), text);
}

TEST(Campaign, FindsWhatIsBrokenFirstAndShrinksIt) {
  const CampaignState state = done({});
  const RunResult result = result_of(state, {}, never);
  ASSERT_FALSE(result.findings.empty());
  for (const Finding& finding : result.findings) EXPECT_TRUE(finding.is_declared);
}

TEST(Campaign, RefusesShardsThatAreNotOneCampaign) {
  const CampaignState one = done({1, 2}), two = done({2, 2});
  EXPECT_EQ(trouble_with({}), "there is nothing to merge");
  EXPECT_EQ(trouble_with({one}), "shard 2/2 is missing");
  EXPECT_EQ(trouble_with({one, one}), "shard 1/2 is given twice");
  CampaignState unfinished = begin(few(), {2, 2});
  EXPECT_EQ(trouble_with({one, unfinished}),
            "shard 2/2 is not finished: 0 of 3 rounds are done; go on with --resume");
  Settings other = few();
  other.seed = 6;
  EXPECT_EQ(trouble_with({one, done({2, 2}, other)}),
            "the shards are not of one campaign: seed, cases, filters or their number differ");
}

TEST(Campaign, KnowsItsShareDone) {
  EXPECT_EQ(begin(few(), {}).share_done(), 0);
  EXPECT_EQ(done({2, 3}).share_done(), 1);
}

std::string trouble_reading(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  try {
    (void)read_state(text.replace(place, from.size(), to));
  } catch (const std::runtime_error& trouble) {
    return trouble.what();
  }
  return "";
}

TEST(Campaign, RefusesAStateThatWasChanged) {
  const CampaignState state = done({2, 3});
  const std::string text = write_state(state);
  const std::string counts = "its counts of cases are not those of its rounds",
                    rounds = "it has more rounds than there are";
  EXPECT_EQ(trouble_reading(text, "\"rounds\": 2", "\"rounds\": 1"), counts);
  EXPECT_EQ(trouble_reading(text, "\"rounds\": 2", "\"rounds\": 3"), rounds);
  EXPECT_EQ(trouble_reading(text, "\"units ahead\": 0", "\"units ahead\": 1"), rounds);
  EXPECT_EQ(trouble_reading(text, "\"units ahead\": 0", "\"units ahead\": 4"), rounds);
  EXPECT_EQ(trouble_reading(text, "\"cases\": 400000", "\"cases\": 40000"), rounds);
  EXPECT_EQ(trouble_reading(text, "\"cases\": 400000", "\"cases\": -1"),
            "its number of cases is not from 1 to 1e12");
  EXPECT_EQ(trouble_reading(text, "\"shard\": [\n  2", "\"shard\": [\n  0"),
            "its shard is not one of its shards");
  const std::string spoilt = trouble_reading(text, "\"verdict\": \"", "\"verdict\": \"x");
  EXPECT_NE(spoilt.find("\" is no number"), std::string::npos) << spoilt;
}

TEST(Campaign, RefusesTextThatIsNoState) {
  for (const char* const text : {"", "{}", "[1]", "{\"seed\": \"x\"}", "nonsense"})
    EXPECT_THROW((void)read_state(text), std::runtime_error) << text;
}

}  // namespace
}  // namespace rayproof::campaign
