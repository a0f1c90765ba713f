#include <gtest/gtest.h>

#include <limits>

#include "case/json/number_text.hpp"
#include "unit/viz/player/player.hpp"
#include "viz/player/player.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/stage_values.hpp"

namespace rayproof::viz {
namespace {

TEST(Player, StepsGoByArrowsDigitsAndTheEnds) {
  Player player = sphere_player();
  const std::size_t last = player.stage().steps.size() - 1;
  ASSERT_GE(last, 3U);
  player.press_key("Right");
  EXPECT_EQ(player.step(), 1U);
  player.press_key("End");
  EXPECT_EQ(player.step(), last);
  player.press_key("Left");
  EXPECT_EQ(player.step(), last - 1);
  player.press_key("3");
  EXPECT_EQ(player.step(), 2U);
  player.press_key("Home");
  EXPECT_EQ(player.step(), 0U);
}

TEST(Player, NothingGoesBeforeTheFirstStepOrBeyondTheLast) {
  Player player = sphere_player();
  for (const char* key : {"Left", "Prior", "0", "999", "1000000000000"}) player.press_key(key);
  EXPECT_EQ(player.step(), 0U);
  for (int i = 0; i < 40; ++i) player.press_key("Right");
  EXPECT_EQ(player.step(), player.stage().steps.size() - 1);
}

TEST(Player, KeysAskTheWindowForWhatOnlyItCanDo) {
  Player player = sphere_player();
  EXPECT_EQ(player.press_key("q"), Request::quit);
  EXPECT_EQ(player.press_key("c"), Request::print_case);
  EXPECT_EQ(player.press_key("s"), Request::save_picture);
  EXPECT_EQ(player.press_key("r"), Request::look_anew);
  for (const char* key : {"Right", "Escape", "Tab", "h", "e", "", "XF86AudioPlay", "plus"})
    EXPECT_EQ(player.press_key(key), Request::none) << key;
  player.press_key("Tab");  // from the slider to the view
  ASSERT_EQ(player.focus(), Focus::view);
  EXPECT_EQ(player.press_key("Left"), Request::move_focused);
  EXPECT_EQ(player.press_key("plus"), Request::nearer);
  EXPECT_EQ(player.press_key("minus"), Request::farther);
}

TEST(Player, TabGoesRoundAllThatTheArrowKeysCanMove) {
  Player player = sphere_player();
  for (const Focus focus : {Focus::slider, Focus::view}) {
    player.press_key("Tab");
    EXPECT_EQ(player.focus(), focus);
  }
  for (const std::string& name : handle_names(player)) {
    player.press_key("Tab");
    EXPECT_EQ(player.focused_handle(), name);
    EXPECT_EQ(player.press_key("Up"), Request::move_focused);
  }
  player.press_key("Tab");
  EXPECT_EQ(player.focus(), Focus::steps);
  player.press_key("Tab", true);
  EXPECT_EQ(player.focused_handle(), handle_names(player).back());
  player.press_key("Escape");
  EXPECT_EQ(player.focus(), Focus::steps);
  EXPECT_EQ(player.focused_handle(), "");
}

TEST(Player, SeveralWalkthroughsFollowOneAnother) {
  Player player(plays_of("all"));
  const std::string first = player.stage().name;
  player.press_key("p");
  EXPECT_EQ(player.stage().name, first);
  player.press_key("n");
  EXPECT_NE(player.stage().name, first);
  EXPECT_EQ(player.step(), 0U);
  for (std::size_t i = 0; i < lessons().size(); ++i) player.press_key("n");
  EXPECT_EQ(player.stage().name, lessons().back().name);
}

TEST(Player, HelpIsShownAndClosedByKeys) {
  Player player = sphere_player();
  player.press_key("h");
  EXPECT_TRUE(player.is_help_shown());
  player.press_key("Escape");
  EXPECT_FALSE(player.is_help_shown());
  player.press_key("question");
  EXPECT_TRUE(player.is_help_shown());
}

TEST(PlayerSlider, ItStandsAtTheFirstHitAndPtIsAmongTheItems) {
  const Player player = sphere_player();
  const StageSlider& slider = *player.stage().slider;
  EXPECT_EQ(player.t(), round_to(Precision::float32, slider.start));
  const StageItem runner = player.shown().steps[0].items.back();
  EXPECT_EQ(runner.points.at(0), slider.origin + player.t() * slider.direction);
  EXPECT_EQ(runner.role, Role::ray);
}

TEST(PlayerSlider, PtIsNotShownWhereTheSceneIsAnother) {
  Player player = sphere_player();
  player.press_key("End");
  ASSERT_TRUE(player.stage().steps[player.step()].is_apart);
  EXPECT_EQ(player.shown().steps.back().items.size(), player.stage().steps.back().items.size());
  EXPECT_TRUE(player.handles().empty());
}

TEST(PlayerSlider, TIsANumberOfTheCasesPrecisionWithinTheRange) {
  Player player = sphere_player();
  for (int i = 0; i < 60; ++i) {
    player.press_key("minus");
    EXPECT_EQ(player.t(), static_cast<double>(static_cast<float>(player.t())));
  }
  EXPECT_EQ(player.t(), static_cast<double>(static_cast<float>(player.stage().slider->from)));
  player.set_t(1e9);
  EXPECT_EQ(player.t(), static_cast<double>(static_cast<float>(player.stage().slider->to)));
}

TEST(PlayerSlider, CommaAndPeriodGoToTheNeighbouringNumber) {
  Player player = sphere_player();
  player.set_t(1);
  player.press_key("period");
  EXPECT_EQ(player.t(), 1 + 0x1p-23);
  player.press_key("comma");
  player.press_key("comma");
  EXPECT_EQ(player.t(), 1 - 0x1p-24);
}

TEST(PlayerSlider, LiveValuesAreRoundedOperationByOperation) {
  Player player = sphere_player();
  const Ray<double>& ray = ray_of(player);
  for (const double wanted : {0.1, 0.7, 1.9474078, 3.3}) {
    player.set_t(wanted);
    const auto t = static_cast<float>(player.t());
    const auto text = [&](int axis) {
      const float product = t * static_cast<float>(ray.direction[axis]);
      return shown(static_cast<double>(static_cast<float>(ray.origin[axis]) + product), Precision::float32);
    };
    const auto values = live_values(*player.stage().slider, player.t(), Precision::float32);
    EXPECT_EQ(values.at(0).rounded, "(" + text(0) + ", " + text(1) + ", " + text(2) + ")") << wanted;
  }
}

TEST(PlayerSlider, TheExactPointHasTwelveTrueDigits) {
  // 0.1f + 3·0.2f in real numbers: 0.100000001490116… + 3·0.200000002980232… = 0.700000010430812…
  StageSlider slider;
  slider.origin = glm::dvec3(static_cast<double>(0.1F));
  slider.direction = glm::dvec3(static_cast<double>(0.2F));
  const auto values = live_values(slider, 3, Precision::float32);
  ASSERT_EQ(values.size(), 1U);
  EXPECT_EQ(values[0].exact, "(0.700000010431, 0.700000010431, 0.700000010431)");
}

TEST(PlayerSlider, AReadoutIsItsPolynomial) {
  StageSlider slider;
  slider.shows_point = false;
  slider.readouts = {{"x² − 3x + 2", {2, -3, 1}}};
  EXPECT_EQ(live_values(slider, 4, Precision::float32)[0].rounded, "6");
  EXPECT_EQ(live_values(slider, 2, Precision::float64)[0].rounded, "0");
}

TEST(PlayerSlider, NeighboursOfZeroAndOfTheLargestNumberAreRight) {
  EXPECT_EQ(neighbour_of(0, 1, Precision::float32), 0x1p-149);
  EXPECT_EQ(neighbour_of(0, -1, Precision::float64), -0x1p-1074);
  EXPECT_EQ(neighbour_of(std::numeric_limits<float>::max(), 1, Precision::float32),
            std::numeric_limits<double>::infinity());
}

TEST(PlayerSlider, AStageWithoutOnePlaysToo) {
  Player player = player_of(R"({"query":"point_in_polygon","point":[1,1],"vertices":[[0,0],[3,0],[0,3]]})",
                            "point_in_polygon/parity");
  ASSERT_FALSE(player.stage().slider);
  for (const char* key : {"plus", "Up", "period", "Right", "Tab", "r"}) player.press_key(key);
  player.set_t(3);
  EXPECT_EQ(player.shown().steps[0].items.size(), player.stage().steps[0].items.size());
}

}  // namespace
}  // namespace rayproof::viz
