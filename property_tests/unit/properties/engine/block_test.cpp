#include "properties/engine/block.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "unit/properties/guests/stranger.hpp"

namespace rayproof {
namespace {

/// Gives no answer to one case of a hundred, as who does not keep from NaN.
struct Failing final : Answerer {
  void answer(std::span<const Case> cases, std::span<Outcome> outcomes) override {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const auto& ray = std::get<RayQuestion>(cases[i].question).ray;
      outcomes[i] = std::fmod(std::abs(ray.origin.x) * 0x1p20, 100) < 1
                        ? Outcome{.kind = OutcomeKind::nonsense, .sentence = "hits[0].t is NaN"}
                        : Outcome{.answer = oracle::answer(cases[i])};
    }
  }
};

/// A block of a failing program's, by this many threads.
BlockResult block_by(std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  Subject failing = guest("sphere", nullptr);
  failing.start = [] { return std::make_unique<Failing>(); };
  const auto& all = families();
  const auto random = std::ranges::find_if(
      all, [](const Family& one) { return one.topic == "sphere" && one.name == "random"; });
  std::atomic<unsigned> others_failed = 0;
  Unit unit{&failing, &*random, Precision::float64};
  unit.others_failed = &others_failed;
  for (std::size_t p = 0; p < properties().size(); ++p)
    if (properties()[p].claim != Claim::nan) unit.tested.push_back(p);  // the oracle is not asked of NaN
  return run_block(unit, 7, 8000, never_stopped);
}

TEST(BlockOfAProgramThatFails, EndsAfterTheSameCasesHoweverManyThreadsThereAre) {
  const BlockResult alone = block_by(1);
  EXPECT_LT(alone.tally.cases + alone.tally.left_out, 8000U) << "after some failures it is asked no more";
  EXPECT_GT(alone.tally.cases, 0U);
  for (const std::size_t threads : {2U, 4U, 4U, 4U}) {
    const BlockResult more = block_by(threads);
    EXPECT_EQ(more.tally.cases, alone.tally.cases);
    EXPECT_EQ(more.tally.left_out, alone.tally.left_out);
    EXPECT_EQ(more.first_broken, alone.first_broken);
  }
}

}  // namespace
}  // namespace rayproof
