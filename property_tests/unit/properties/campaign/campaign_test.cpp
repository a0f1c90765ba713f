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

TEST(Campaign, ThatWasStoppedGoesOnToTheSameEnd) {
  CampaignState state = begin(few(), {});
  std::atomic<bool> stop{false};
  run(state, {.round = [&](const CampaignState& now) { stop = now.rounds == 3; }}, stop);
  EXPECT_EQ(state.rounds, 3U);
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

TEST(Campaign, RefusesTextThatIsNoState) {
  for (const char* const text : {"", "{}", "[1]", "{\"seed\": \"x\"}", "nonsense"})
    EXPECT_THROW((void)read_state(text), std::runtime_error) << text;
}

}  // namespace
}  // namespace rayproof::campaign
