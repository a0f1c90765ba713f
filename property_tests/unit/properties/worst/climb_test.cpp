/// \file
/// The search for the worst case, on an error that is made up.

#include "properties/worst/climb.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "case/writer.hpp"
#include "properties/numbers.hpp"

namespace rayproof::worst {
namespace {

const std::atomic<bool> never{false}, at_once{true};
void ignore(double /*done*/) {}

std::vector<const Family*> families_of(const std::string& topic) {
  std::vector<const Family*> all;
  for (const Family& family : families())
    if (family.topic == topic) all.push_back(&family);
  return all;
}

/// Large where two of an equation's coefficients are near a ratio that no family is aimed at, and where the
/// third is near a number.
ErrorList made_up(const Case& one, bool /*with_details*/) {
  const auto& [a, b, c] = std::get<Quadratic<double>>(one.question);
  const double off = std::abs(a / b - 0.71828) + std::abs(c - 3.14159);
  return {1 / (off + 1e-30)};
}

Climbed climbed(std::uint64_t seed, bool is_guided = true, int jobs = 2) {
  const Ground ground{families_of("quadratic"), Precision::float64, made_up};
  const Budget budget{seed, 40'000, {}};
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(jobs));
  tbb::task_arena arena(jobs);
  return arena.execute([&] {
    return is_guided ? climb(ground, budget, {}, never, ignore) : draw_only(ground, budget, never, ignore);
  });
}

TEST(Climb, FindsMuchWorseThanDrawsAlone) {
  const Climbed by_draws = climbed(1, false), guided = climbed(1);
  ASSERT_TRUE(by_draws.worst[0] && guided.worst[0]);
  EXPECT_EQ(by_draws.cases, guided.cases);
  EXPECT_GT(guided.worst[0]->error, 1000 * by_draws.worst[0]->error);
}

/// With a pole at a number of many digits, far from what the families draw.
ErrorList with_a_pole(const Case& one, bool /*with_details*/) {
  const auto& [a, b, c] = std::get<Quadratic<double>>(one.question);
  return {1 / (std::abs(a - 987'654.321'012'345'678) + 1e-300)};
}

TEST(Climb, GoesStraightToAPole) {
  const Ground ground{families_of("quadratic"), Precision::float64, with_a_pole};
  const Climbed guided = climb(ground, {5, 20'000, {}}, {}, never, ignore);
  EXPECT_GT(guided.worst[0]->error, 1e9) << "an ulp of the place is 1e-10";
}

TEST(Climb, IsTheSameForEveryNumberOfThreads) {
  const Climbed alone = climbed(2, true, 1), together = climbed(2, true, 3);
  ASSERT_TRUE(alone.worst[0] && together.worst[0]);
  EXPECT_EQ(write_case(alone.worst[0]->one), write_case(together.worst[0]->one));
  EXPECT_EQ(alone.worst[0]->error, together.worst[0]->error);
  EXPECT_NE(write_case(climbed(3).worst[0]->one), write_case(alone.worst[0]->one));
}

TEST(Climb, ReportsTheErrorOfItsCase) {
  const Climbed guided = climbed(4);
  EXPECT_EQ(made_up(guided.worst[0]->one, true)[0], guided.worst[0]->error);
  for (std::size_t kind = 1; kind < error_kinds; ++kind) EXPECT_FALSE(guided.worst[kind]);
}

TEST(Climb, ThatIsStoppedKeepsWhatItStartedWith) {
  const Ground ground{families_of("quadratic"), Precision::float64, made_up};
  const Case start{.question = Quadratic<double>{0.72, 1, 3}};
  const Climbed stopped = climb(ground, {}, {start}, at_once, ignore);
  EXPECT_EQ(stopped.cases, 0U);
  ASSERT_TRUE(stopped.worst[0]);
  EXPECT_EQ(write_case(stopped.worst[0]->one), write_case(start));
}

}  // namespace
}  // namespace rayproof::worst
