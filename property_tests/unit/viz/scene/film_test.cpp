#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "unit/viz/player/player.hpp"
#include "viz/scene/film.hpp"

namespace rayproof::viz {
namespace {

Stage sphere_stage() { return sphere_player().stage(); }

std::size_t lights_in(const Stage& stage, const Stage& shown) {
  return shown.steps[0].items.size() - stage.steps[0].items.size() - 1;  // without p(t)
}

TEST(Film, EveryStepIsShownInItsOrderWithTimeToRead) {
  const Stage stage = sphere_stage();
  std::size_t step = 0;
  std::vector<int> longest(stage.steps.size());
  for (const Shot& shot : shots_of(stage)) {
    EXPECT_GE(shot.step, step);
    step = shot.step;
    longest[step] = std::max(longest[step], shot.count);
  }
  EXPECT_EQ(step + 1, stage.steps.size());
  for (const int count : longest) EXPECT_GE(count, 2 * film_rate);
}

TEST(Film, TheRayTravelsToPtAndLightsUpEachHitAsItPasses) {
  const Stage stage = sphere_stage();
  const StageSlider& slider = *stage.slider;
  std::size_t lights = 0;
  for (const Shot& shot : shots_of(stage)) {
    if (shot.step > 0) break;
    const Stage shown = stage_at(stage, shot);
    for (const StageItem& item : shown.scene) {
      if (!shot.is_arrival || item.form != Form::arrow || item.role != Role::ray) continue;
      EXPECT_EQ(item.points[1], slider.origin + shot.t * slider.direction);
    }
    EXPECT_GE(lights_in(stage, shown), shot.is_arrival ? lights : 0);
    lights = std::max(lights, lights_in(stage, shown));
    const bool is_before = shot.is_arrival && shot.t < 0.98 * slider.start;
    EXPECT_TRUE(!is_before || lights_in(stage, shown) == 0) << shot.t;
  }
  EXPECT_GE(lights, 2U);  // in and out
}

TEST(Film, InLaterStepsTRunsToTheFirstHitAndNothingElseIsAdded) {
  const Stage stage = sphere_stage();
  for (const Shot& shot : shots_of(stage)) {
    if (shot.step == 0) continue;
    const bool is_apart = stage.steps[shot.step].is_apart;
    EXPECT_LE(shot.t, stage.slider->start);
    EXPECT_EQ(stage_at(stage, shot).steps[shot.step].items.size(),
              stage.steps[shot.step].items.size() + (is_apart ? 0 : 1));
  }
}

}  // namespace
}  // namespace rayproof::viz
