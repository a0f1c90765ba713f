#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "unit/viz/player.hpp"
#include "viz/flat/orbit.hpp"
#include "viz/page/stage_json.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

TEST(PlayerDrag, TheTipGivesANewDirectionAndEverythingIsComputedAgain) {
  Player player = sphere_player();
  const Ray<double> before = ray_of(player);
  const std::string words = stage_json(player.stage());
  const Point from = seen(player, handle_of(player, Grip::tip));
  drag(player, from, {from.x - 20, from.y + 40});
  EXPECT_EQ(ray_of(player).origin, before.origin);
  EXPECT_NE(ray_of(player).direction, before.direction);
  EXPECT_NE(stage_json(player.stage()), words);
  // What is shown is what anybody else computes of the same case.
  const Stage again = stage_of(report_of(player.stage().one, "sphere/centred"));
  EXPECT_EQ(stage_json(player.stage()), stage_json(again));
}

TEST(PlayerDrag, TheTipFollowsThePointerToAPixel) {
  Player player = sphere_player();
  const Handle tip = handle_of(player, Grip::tip);
  const Point from = seen(player, tip);
  const Point to{from.x - 35, from.y - 60};
  player.press(from);
  player.drag_to(to);
  const Point now = player.projection().to_pixels(place_of(tip, player.stage().one));
  EXPECT_NEAR(now.x, to.x, 1);
  EXPECT_NEAR(now.y, to.y, 1);
}

TEST(PlayerDrag, TheOriginMovesInThePlaneOfTheScreenAndTheDirectionStays) {
  Player player = sphere_player();
  const Ray<double> before = ray_of(player);
  const Point from = seen(player, handle_of(player, Grip::origin));
  const double pixel = 1 / player.projection().pixels_per_length();
  player.press(from);
  player.drag_to({from.x + 50, from.y + 30});
  const glm::dvec3 moved = ray_of(player).origin - before.origin;
  EXPECT_NEAR(glm::dot(moved, player.camera().right), 50 * pixel, pixel);
  EXPECT_NEAR(glm::dot(moved, player.camera().up), -30 * pixel, pixel);
  EXPECT_NEAR(glm::dot(moved, player.camera().toward), 0, pixel);
  EXPECT_EQ(ray_of(player).direction, before.direction);
}

TEST(PlayerDrag, ANewCaseHasShortDecimalsOfItsPrecision) {
  Player player = sphere_player();
  const Point from = seen(player, handle_of(player, Grip::origin));
  drag(player, from, {from.x + 33.3, from.y + 21.7});
  for (int axis = 0; axis < 3; ++axis) {
    const double x = ray_of(player).origin[axis];
    EXPECT_EQ(x, static_cast<double>(static_cast<float>(x)));
    EXPECT_LE(shown(x, Precision::float32).size(), 7U) << shown(x, Precision::float32);
  }
}

TEST(PlayerDrag, BackAgainIsTheFirstCase) {
  Player player = sphere_player();
  const std::string first = write_case(player.stage().one);
  const Point from = seen(player, handle_of(player, Grip::origin));
  player.press(from);
  player.drag_to({from.x + 90, from.y + 44});
  EXPECT_NE(write_case(player.stage().one), first);
  player.drag_to(from);
  EXPECT_EQ(write_case(player.stage().one), first);
}

TEST(PlayerDrag, AZeroDirectionIsRefusedInOneLineAndTheCaseBeforeStays) {
  Player player = sphere_player();
  const std::string first = write_case(player.stage().one);
  // Turned so that the ray lies in the plane of the screen, the tip can be dragged onto the origin.
  const glm::dvec3 d = ray_of(player).direction;
  const double angle = std::atan2(glm::dot(d, player.camera().toward), glm::dot(d, player.camera().right));
  drag(player, {100, 380}, {100 + 100 * angle, 380});
  ASSERT_NEAR(glm::dot(d, player.camera().toward), 0, 1e-9);
  const Handle tip = handle_of(player, Grip::tip);
  const Point origin = seen(player, handle_of(player, Grip::origin));
  player.press(seen(player, tip));
  player.drag_to(origin);
  EXPECT_NE(player.complaint().find("ray.direction must not be zero"), std::string::npos)
      << player.complaint();
  EXPECT_EQ(player.complaint().find('\n'), std::string::npos);
  EXPECT_EQ(write_case(player.stage().one), first);
  EXPECT_TRUE(has_text(player.picture(), "ray.direction must not be zero"));
  player.drag_to({origin.x + 60, origin.y});
  EXPECT_EQ(player.complaint(), "");
}

TEST(PlayerDrag, WhatTheCallbackThrowsIsAComplaint) {
  const Stage stage = stage_of(report_of(read_case(sphere_case), "sphere/centred"));
  Player player({{stage, [](const Case&) -> Stage { throw std::runtime_error("no such sphere"); }}});
  const Point from = seen(player, handle_of(player, Grip::origin));
  drag(player, from, {from.x + 9, from.y});
  EXPECT_EQ(player.complaint().find("no such sphere"), 0U);
  EXPECT_EQ(stage_json(player.stage()), stage_json(stage));
}

TEST(PlayerDrag, ResetBringsBackTheFirstCaseViewAndT) {
  Player player = sphere_player();
  const std::string first = stage_json(player.stage());
  const Picture picture = player.picture();
  const Point from = seen(player, handle_of(player, Grip::tip));
  drag(player, from, {from.x - 30, from.y + 50});
  drag(player, {100, 380}, {160, 330});
  player.turn_wheel(3);
  player.press_key("plus");
  player.press_key("r");
  EXPECT_EQ(stage_json(player.stage()), first);
  EXPECT_EQ(player.t(), static_cast<double>(static_cast<float>(player.stage().slider->start)));
  EXPECT_EQ(player.picture().elements.size(), picture.elements.size());
}

TEST(PlayerDrag, AnUntouchedSliderStaysAtTheFirstHitOfTheNewCase) {
  Player player = sphere_player();
  const Point from = seen(player, handle_of(player, Grip::origin));
  drag(player, from, {from.x + 40, from.y});
  EXPECT_EQ(player.t(), static_cast<double>(static_cast<float>(player.stage().slider->start)));
  player.set_t(1.5);
  const Point next = seen(player, handle_of(player, Grip::origin));
  drag(player, next, {next.x, next.y + 10});
  EXPECT_EQ(player.t(), 1.5);
}

TEST(PlayerDrag, ElsewhereItTurnsTheSceneWithThePointer) {
  Player player = sphere_player();
  const glm::dvec3 nearest = player.projection().view.centre + player.camera().toward;
  const Point before = player.projection().to_pixels(nearest);
  drag(player, {100, 380}, {130, 395});
  const Point after = player.projection().to_pixels(nearest);
  EXPECT_GT(after.x, before.x + 5);
  EXPECT_GT(after.y, before.y + 5);
  EXPECT_EQ(write_case(player.stage().one), write_case(sphere_player().stage().one));
}

TEST(PlayerDrag, TheCameraStaysSquareHoweverOftenItTurns) {
  StageCamera camera;
  for (int i = 0; i < 20000; ++i) camera = turned(camera, 0.37, -0.21);
  EXPECT_NEAR(glm::length(camera.right), 1, 1e-14);
  EXPECT_NEAR(glm::length(camera.up), 1, 1e-14);
  EXPECT_NEAR(glm::length(camera.toward), 1, 1e-14);
  EXPECT_NEAR(glm::dot(camera.right, camera.up), 0, 1e-14);
  EXPECT_NEAR(glm::dot(camera.right, camera.toward), 0, 1e-14);
  EXPECT_GT(glm::dot(glm::cross(camera.right, camera.up), camera.toward), 0);
}

TEST(PlayerDrag, AFlatSceneDoesNotTurn) {
  Player player =
      player_of(R"({"query":"quadratic","precision":"float32","a":1,"b":-3,"c":2})", "quadratic/textbook");
  const glm::dvec3 toward = player.camera().toward;
  drag(player, {100, 300}, {300, 200});
  EXPECT_EQ(player.camera().toward, toward);
  EXPECT_TRUE(player.handles().empty());
}

TEST(PlayerDrag, ThePointOfAPolygonMoves) {
  Player player = player_of(R"({"query":"point_in_polygon","point":[1,1],"vertices":[[0,0],[3,0],[0,3]]})",
                            "point_in_polygon/parity");
  const Point from = seen(player, handle_of(player, Grip::point));
  const double pixels = player.projection().pixels_per_length();
  drag(player, from, {from.x + pixels, from.y - 0.5 * pixels});
  const auto& asked = std::get<PointAndPolygon<double>>(player.stage().one.question);
  EXPECT_NEAR(asked.point.x, 2, 0.02);
  EXPECT_NEAR(asked.point.y, 1.5, 0.02);
}

TEST(PlayerDrag, AnOriginOutOfSightCanNotBeTakenHoldOf) {
  Player player(plays_of("far-sphere"));
  player.press_key("End");
  player.press_key("2");
  for (const Handle& handle : player.handles()) {
    const Point p = seen(player, handle);
    EXPECT_TRUE(slide_scene.holds(p)) << p.x << ' ' << p.y;
  }
}

TEST(PlayerDrag, EveryLessonCanBeDraggedInEveryStepWithoutHarm) {
  for (const Lesson& lesson : lessons()) {
    Player player(plays_of(lesson.name));
    for (std::size_t i = 0; i < player.stage().steps.size(); i += 2) {
      player.press_key(std::to_string(i + 1));
      for (const Handle& handle : player.handles()) {
        const Point from = seen(player, handle);
        drag(player, from, {from.x - 37, from.y + 23});
        EXPECT_EQ(player.complaint(), "") << lesson.name << ' ' << i;
        EXPECT_FALSE(player.picture().elements.empty());
        player.press_key("r");
      }
    }
  }
}

}  // namespace
}  // namespace rayproof::viz
