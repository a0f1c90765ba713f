#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <rayproof/ray.hpp>

#include "case/json/number_text.hpp"
#include "unit/viz/player.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/live_values.hpp"

namespace rayproof::viz {
namespace {

/// The tip of the triangle that points at p(t): the first point of the picture's last area, which is its own.
Point runner_of(const Picture& picture) {
  Point tip{};
  for (const Element& element : picture.elements) {
    if (const auto* area = std::get_if<Area>(&element); area != nullptr && area->role == Role::ray)
      tip = area->points.front();
  }
  return tip;
}

TEST(PlayerSlider, ItStandsAtTheFirstHitAtFirst) {
  const Player player = sphere_player();
  EXPECT_EQ(player.t(), round_to(Precision::float32, player.stage().slider->start));
  EXPECT_TRUE(has_text(player.picture(), "t = " + shown(player.t(), Precision::float32)));
}

TEST(PlayerSlider, ItMovesThePointAlongTheRay) {
  Player player = sphere_player();
  for (const double wanted : {1.0, 1.5, 2.5, 3.25}) {
    player.set_t(wanted);
    const double t = player.t();
    EXPECT_EQ(t, wanted);
    const Ray<double>& ray = ray_of(player);
    const Point expected = player.projection().to_pixels(ray.origin + t * ray.direction);
    const Point tip = runner_of(player.picture());
    EXPECT_NEAR(tip.x, expected.x, 1e-6) << t;
    EXPECT_NEAR(tip.y, expected.y, 1e-6) << t;
  }
}

TEST(PlayerSlider, TheMouseMovesItOverItsWholeRange) {
  Player player = sphere_player();
  const StageSlider& slider = *player.stage().slider;
  drag(player, slider_track.centre(), {-500, slider_track.centre().y});
  EXPECT_EQ(player.t(), static_cast<double>(static_cast<float>(slider.from)));
  drag(player, slider_track.centre(), {5000, 0});
  EXPECT_EQ(player.t(), static_cast<double>(static_cast<float>(slider.to)));
  player.drag_to({400, 602});  // the button is up
  EXPECT_EQ(player.t(), static_cast<double>(static_cast<float>(slider.to)));
}

TEST(PlayerSlider, TIsANumberOfTheCasesPrecision) {
  Player player = sphere_player();
  for (int i = 0; i < 60; ++i) {
    player.press_key("minus");
    EXPECT_EQ(player.t(), static_cast<double>(static_cast<float>(player.t())));
  }
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
    const auto along = [&](int axis) {
      const float product = t * static_cast<float>(ray.direction[axis]);
      return static_cast<float>(ray.origin[axis]) + product;
    };
    const auto text = [&](int axis) { return shown(static_cast<double>(along(axis)), Precision::float32); };
    EXPECT_TRUE(has_text(player.picture(), "(" + text(0) + ", " + text(1) + ", " + text(2) + ")")) << wanted;
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

TEST(PlayerSlider, APointOfAScenesOwnIsNotShownWhereTheSceneIsAnother) {
  Player player = sphere_player();
  for (std::size_t i = 0; i < player.stage().steps.size(); ++i) {
    if (player.stage().steps[i].is_apart) {
      const Point tip = runner_of(player.picture());
      EXPECT_EQ(tip.x, 0) << i;
      EXPECT_TRUE(player.handles().empty());
    }
    player.press_key("Right");
  }
}

}  // namespace
}  // namespace rayproof::viz
