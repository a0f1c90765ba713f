#include <gtest/gtest.h>

#include <cmath>

#include "unit/viz/player.hpp"
#include "viz/scene/label_places.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/live_values.hpp"

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

TEST(Player, TheSlideOfTheStepIsShown) {
  Player player = sphere_player();
  for (const StageStep& step : player.stage().steps) {
    EXPECT_TRUE(has_text(player.picture(), step.title)) << step.title;
    player.press_key("Right");
  }
}

TEST(Player, EveryButtonLiesInsideThePictureAndOverNoOther) {
  for (const ButtonState& state :
       {ButtonState{0, 1, 0, 1, false}, ButtonState{3, 8, 1, 3, true}, ButtonState{19, 24, 0, 40, false}}) {
    const auto buttons = buttons_of(state);
    for (std::size_t i = 0; i < buttons.size(); ++i) {
      const PixelBox& a = buttons[i].box;
      EXPECT_GE(a.left, 0);
      EXPECT_LE(a.right(), player_width);
      EXPECT_LE(a.bottom(), slider_track.top);
      EXPECT_GE(a.left, i > 0 ? buttons[i - 1].box.right() : 0) << buttons[i].text;
      EXPECT_LE(text_width(buttons[i].text, a.width < 24 ? 11 : 14, true), a.width) << buttons[i].text;
    }
  }
}

TEST(Player, AClickOnAButtonDoesWhatItsKeyDoes) {
  Player player = sphere_player();
  for (const Button& button : player.buttons()) {
    if (!button.is_enabled) continue;
    Player clicked = player;
    Player typed = player;
    EXPECT_EQ(clicked.press(button.box.centre()), typed.press_key(button.key)) << button.key;
    EXPECT_EQ(clicked.step(), typed.step()) << button.key;
    EXPECT_EQ(clicked.is_help_shown(), typed.is_help_shown()) << button.key;
  }
}

TEST(Player, AButtonThatIsGreyDoesNothing) {
  Player player = sphere_player();
  const auto buttons = player.buttons();
  ASSERT_FALSE(buttons.front().is_enabled);
  player.press(buttons.front().box.centre());
  EXPECT_EQ(player.step(), 0U);
}

TEST(Player, OnlyQuitAsksToQuitOnlyCForTheCaseAndOnlySForThePicture) {
  Player player = sphere_player();
  EXPECT_EQ(player.press_key("q"), Request::quit);
  EXPECT_EQ(player.press_key("c"), Request::print_case);
  EXPECT_EQ(player.press_key("s"), Request::save_picture);
  for (const char* key : {"Right", "Escape", "Tab", "h", "e", "", "XF86AudioPlay", "r"})
    EXPECT_EQ(player.press_key(key), Request::none) << key;
}

TEST(Player, HelpTakesTheSlidesPlaceAndNamesEveryKeyOfTheButtons) {
  Player player = sphere_player();
  player.press_key("h");
  EXPECT_TRUE(player.is_help_shown());
  EXPECT_FALSE(has_text(player.picture(), player.stage().steps[0].title));
  EXPECT_TRUE(has_text(player.picture(), "Drag a square"));
  EXPECT_TRUE(has_text(player.picture(), "quit"));
  player.press_key("Escape");
  EXPECT_FALSE(player.is_help_shown());
  player.press_key("question");
  player.press({400, 300});
  EXPECT_FALSE(player.is_help_shown());
}

TEST(Player, TabGoesRoundAllThatTheArrowKeysCanMove) {
  Player player = sphere_player();
  for (const Focus focus : {Focus::slider, Focus::view, Focus::origin, Focus::tip, Focus::steps}) {
    player.press_key("Tab");
    EXPECT_EQ(player.focus(), focus);
  }
  player.press_key("Tab", true);
  EXPECT_EQ(player.focus(), Focus::tip);
  player.press_key("Escape");
  EXPECT_EQ(player.focus(), Focus::steps);
}

TEST(Player, ArrowKeysMoveWhatHasTheFocus) {
  Player player = sphere_player();
  const double t = player.t();
  player.press_key("Tab");
  player.press_key("Right");
  EXPECT_GT(player.t(), t);
  player.press_key("Tab");
  const glm::dvec3 toward = player.camera().toward;
  player.press_key("Right");
  EXPECT_NE(player.camera().toward, toward);
  player.press_key("Tab");
  const Ray<double> ray = ray_of(player);
  player.press_key("Up");
  EXPECT_NE(ray_of(player).origin, ray.origin);
  player.press_key("Tab");
  player.press_key("Up");
  EXPECT_NE(ray_of(player).direction, ray.direction);
  EXPECT_EQ(player.step(), 0U);
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

TEST(Player, AStageWithoutASliderPlaysToo) {
  Player player = player_of(R"({"query":"point_in_polygon","point":[1,1],"vertices":[[0,0],[3,0],[0,3]]})",
                            "point_in_polygon/parity");
  ASSERT_FALSE(player.stage().slider);
  for (const char* key : {"plus", "Up", "period", "Right", "Tab", "r"}) player.press_key(key);
  player.press(slider_track.centre());
  player.drag_to({300, 602});
  EXPECT_FALSE(has_text(player.picture(), "t = "));
}

TEST(Player, TheWheelGoesNearer) {
  Player player = sphere_player();
  const double before = player.projection().pixels_per_length();
  player.turn_wheel(1);
  EXPECT_GT(player.projection().pixels_per_length(), before);
  player.turn_wheel(-1);
  EXPECT_NEAR(player.projection().pixels_per_length(), before, 1e-9 * before);
  player.turn_wheel(1000);
  EXPECT_TRUE(std::isfinite(player.projection().pixels_per_length()));
}

}  // namespace
}  // namespace rayproof::viz
