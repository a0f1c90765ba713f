#include "properties/engine/judged.hpp"

#include <gtest/gtest.h>

#include "properties/engine/engine.hpp"

namespace rayproof {
namespace {

const oracle::Judgement some{.residual = 3};

TEST(JudgedBlocks, ABlockIsKnownAsLongAsItIsOneOfTheLastFour) {
  JudgedBlocks blocks;
  blocks.block(1, 10)[9].add(Position::inside, some);
  for (const std::uint64_t seed : {2U, 3U, 4U}) EXPECT_EQ(blocks.block(seed, 10).size(), 10U);
  EXPECT_NE(blocks.block(1, 10)[9].find(Position::inside), nullptr);
  (void)blocks.block(5, 10);
  EXPECT_EQ(blocks.block(1, 10)[9].find(Position::inside), nullptr);
}

/// What was counted of a method, family for family.
std::vector<Tally> tallies_of(const RunResult& result, const std::string& method) {
  std::vector<Tally> all;
  for (const Unit& unit : result.units)
    if (unit.subject->name == method) all.push_back(unit.tally);
  return all;
}

TEST(JudgedBlocks, AMethodIsJudgedTheSameAloneAndBesideOthers) {
  const std::atomic<bool> no_stop{false};
  Settings settings;
  settings.cases = 500;
  settings.shapes = {"triangle"};
  settings.families = {"random", "near_edges"};
  const RunResult beside = run_plan(make_plan(settings), {}, {}, no_stop);
  settings.methods = {"plucker"};
  const RunResult alone = run_plan(make_plan(settings), {}, {}, no_stop);
  const auto expected = tallies_of(alone, "plucker"), got = tallies_of(beside, "plucker");
  ASSERT_EQ(got.size(), expected.size());
  ASSERT_EQ(got.size(), 4U);
  for (std::size_t i = 0; i < got.size(); ++i) {
    EXPECT_EQ(got[i].worst.residual, expected[i].worst.residual);
    EXPECT_EQ(got[i].worst.verdict, expected[i].worst.verdict);
    EXPECT_EQ(got[i].worst.wrong, expected[i].worst.wrong);
    for (std::size_t p = 0; p < got[i].properties.size(); ++p)
      EXPECT_EQ(got[i].properties[p].broken, expected[i].properties[p].broken);
  }
}

}  // namespace
}  // namespace rayproof
