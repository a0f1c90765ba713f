#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "unit/viz/player/player.hpp"
#include "viz/page/page.hpp"

namespace rayproof::viz {
namespace {

/// A ray to (0, 0, 0) and a shape there, as a case.
std::string case_of(const std::string& shape, const std::string& more = {}) {
  return R"({"precision":"float32","ray":{"origin":[-3,-1,0.5],"direction":[1.5,0.5,-0.25]},"shape":)" +
         shape + more + "}";
}

struct Moved {
  std::string shape, method, handle;
  glm::dvec3 by;
  std::string field;  ///< as the case is written afterwards
  std::string more{};
};

TEST(Handles, EachMovesWhatItIsNamedAfterAndNothingElse) {
  const std::string matrix = R"(,"transform":[[1,0,0,0.5],[0,1,0,0],[0,0,2,0],[0,0,0,1]])";
  const std::string sphere = R"({"type":"sphere","center":[0,0,0],"radius":1})";
  const std::string triangle = R"({"type":"triangle","a":[0,-1,-1],"b":[0,1.5,-1],"c":[0,0,1]})";
  const std::vector<Moved> all{
      {sphere, "sphere/centred", "center", {0, 0.25, 0.5}, R"("center": [0, 0.25, 0.5])"},
      {sphere, "sphere/centred", "radius", {0, 0, 0}, R"("radius": 1)"},
      {triangle, "triangle/moller_trumbore", "b", {0, 0.25, 0}, R"("b": [0, 1.75, -1])"},
      {R"({"type":"box","min":[-1,-1,-1],"max":[1,1,1]})",
       "box/slabs",
       "max",
       {0.5, 0, -0.5},
       R"("max": [1.5, 1, 0.5])"},
      {R"({"type":"parallelepiped","corner":[-1,-1,-1],"edges":[[1.5,0,0],[0,1.5,0],[0,0,1.5]]})",
       "parallelepiped/unit_cube",
       "edges 2",
       {0, 0.5, 0},
       R"("edges": [[1.5, 0, 0], [0, 2, 0], [0, 0, 1.5]])"},
      {R"({"type":"cylinder","rx":1,"ry":1,"height":2,"capped":true})",
       "cylinder/textbook",
       "height",
       {0.3, 0.3, 0.5},
       R"("height": 2.5)"},
      {R"({"type":"plane","point":[0,0,0],"normal":[1,0,0]})",
       "plane/point_normal",
       "point",
       {0.5, 0, 0},
       R"("point": [0.5, 0, 0])"},
      {R"({"type":"plane","normal":[2,0,0],"d":0})", "plane/implicit", "d", {0.5, 0, 0}, R"("d": -1)"},
      {R"({"type":"polygon","vertices":[[0,-1,-1],[0,1,-1],[0,1,1],[0,-1,1]]})",
       "polygon/parity",
       "vertices 3",
       {0, 0.5, 0.5},
       R"([0, 1.5, 1.5])"},
      {sphere, "sphere/centred", "translation", {0.5, 0, 0}, "1.0", matrix},
      {sphere, "sphere/centred", "z axis", {0, 0, 1.25}, "3", matrix},
  };
  for (const Moved& one : all) {
    const Case before = read_case(case_of(one.shape, one.more));
    bool is_found = false;
    for (const Handle& handle : shape_handles(before, 2, {1, 0, 0})) {
      if (handle.name != one.handle) continue;
      is_found = true;
      const Case after = moved(before, handle, handle.at + one.by, 0.01);
      const std::string text = write_case(after);
      EXPECT_TRUE(!one.more.empty() || text.find(one.field) != std::string::npos) << text;
      EXPECT_EQ(std::get<RayQuestion>(after.question).ray.direction,
                std::get<RayQuestion>(before.question).ray.direction);
      EXPECT_TRUE(one.by == glm::dvec3(0) || text != write_case(before)) << one.handle;
      // The handle is where it was moved to, to what the rounding leaves; a length along its axis alone.
      for (const Handle& again : shape_handles(after, 2, {1, 0, 0})) {
        const bool is_it = again.name == one.handle && one.handle != "height";
        EXPECT_TRUE(!is_it || glm::length(again.at - handle.at - one.by) < 0.02) << one.handle;
      }
    }
    EXPECT_TRUE(is_found) << one.handle;
  }
}

TEST(Handles, ARadiusIsHowFarItsHandleIsFromTheCentreInAnyDirection) {
  Player player = sphere_player();
  const glm::dvec3 centre(0.2, 0.1, 0.3);
  const glm::dvec3 from = handle_of(player, "radius").at;
  drag(player, "radius", centre + glm::dvec3(0, 0, 2) - from);
  EXPECT_EQ(std::get<Sphere<double>>(question_of(player).shape).radius, 2);
}

TEST(Handles, TheOriginMovesAndTheDirectionStays) {
  Player player = sphere_player();
  const Ray<double> before = ray_of(player);
  drag(player, "origin", {0.5, 0, 0.25});
  EXPECT_EQ(ray_of(player).direction, before.direction);
  EXPECT_NEAR(ray_of(player).origin.x, -3.2, 1e-6);
  EXPECT_EQ(ray_of(player).origin.y, before.origin.y);  // the bits of what did not move
}

TEST(Handles, TheTipTurnsTheRayAndTheOriginStays) {
  Player player = sphere_player();
  const Ray<double> before = ray_of(player);
  const glm::dvec3 tip = handle_of(player, "tip").at;
  drag(player, "tip", {0, 0.4, 0.2});
  EXPECT_EQ(ray_of(player).origin, before.origin);
  const glm::dvec3 to = tip + glm::dvec3(0, 0.4, 0.2) - before.origin;
  EXPECT_LT(glm::length(glm::cross(glm::normalize(to), glm::normalize(ray_of(player).direction))), 0.01);
}

TEST(Handles, EveryMoveIsAShortDecimalOfTheCasesPrecisionAndRunsTheKernelAgain) {
  Player player = sphere_player();
  drag(player, "tip", {0.123456789, 0.23456789, 0.3456789}, 0.01);
  const std::string text = write_case(player.stage().one);
  EXPECT_LT(text.find("\"direction\""), text.size());
  for (int axis = 0; axis < 3; ++axis) {
    const double x = ray_of(player).direction[axis];
    EXPECT_EQ(x, static_cast<double>(static_cast<float>(std::round(x * 1000) / 1000)));
  }
  EXPECT_EQ(stage_json(player.stage()),
            stage_json(stage_of(report_of(player.stage().one, "sphere/centred"))));
}

TEST(Handles, TheViewRestsWhileOneIsHeldAndADragIsCountedFromWhereItBegan) {
  Player player = sphere_player();
  const double radius = player.shown().steps[0].view.radius;
  const glm::dvec3 at = handle_of(player, "center").at;
  player.grasp("center");
  for (int i = 1; i <= 9; ++i) player.drag_to(at + glm::dvec3(0, 0, 0.333 * i), 0.01);
  EXPECT_EQ(player.shown().steps[0].view.radius, radius);
  EXPECT_TRUE(player.is_held());
  player.drag_to(at, 0.01);
  EXPECT_EQ(write_case(player.stage().one), write_case(sphere_player().stage().one));
  player.release();
  player.drag_to(at + glm::dvec3(1), 0.01);  // nothing is held
  EXPECT_EQ(write_case(player.stage().one), write_case(sphere_player().stage().one));
}

TEST(Handles, WhatTheFormatRefusesIsSaidAndTheCaseBeforeStays) {
  Player player = player_of(case_of(R"({"type":"box","min":[-1,-1,-1],"max":[1,1,1]})"), "box/slabs");
  const std::string before = stage_json(player.stage());
  drag(player, "min", {3, 0, 0});
  EXPECT_NE(player.complaint().find("min"), std::string::npos) << player.complaint();
  EXPECT_EQ(stage_json(player.stage()), before);
  drag(player, "min", {0.5, 0, 0});
  EXPECT_EQ(player.complaint(), "");
}

TEST(Handles, ResetBringsBackTheFirstCaseAndT) {
  Player player = sphere_player();
  const std::string first = stage_json(player.stage());
  drag(player, "radius", {0.3, 0, 0});
  player.press_key("plus");
  player.press_key("r");
  EXPECT_EQ(stage_json(player.stage()), first);
  EXPECT_EQ(player.t(), static_cast<double>(static_cast<float>(player.stage().slider->start)));
}

TEST(Handles, AnUntouchedSliderStaysAtTheFirstHitOfTheNewCase) {
  Player player = sphere_player();
  drag(player, "origin", {0.3, 0, 0});
  EXPECT_EQ(player.t(), static_cast<double>(static_cast<float>(player.stage().slider->start)));
  player.set_t(1.5);
  drag(player, "origin", {0, 0.1, 0});
  EXPECT_EQ(player.t(), 1.5);
}

TEST(Handles, APointAndThePolygonAroundItMove) {
  Player player = player_of(R"({"query":"point_in_polygon","point":[1,1],"vertices":[[0,0],[3,0],[0,3]]})",
                            "point_in_polygon/parity");
  EXPECT_EQ(handle_names(player),
            (std::vector<std::string>{"point", "vertices 1", "vertices 2", "vertices 3"}));
  drag(player, "point", {1, 0.5, 0});
  drag(player, "vertices 2", {1, -1, 0});
  const auto& asked = std::get<PointAndPolygon<double>>(player.stage().one.question);
  EXPECT_EQ(asked.point.x, 2);
  EXPECT_EQ(asked.point.y, 1.5);
  EXPECT_EQ(asked.vertices[1].x, 4);
  EXPECT_EQ(asked.vertices[1].y, -1);
}

TEST(Handles, EveryLessonCanBeDraggedInEveryStepWithoutHarm) {
  for (const Lesson& lesson : lessons()) {
    Player player(plays_of(lesson.name));
    for (std::size_t i = 0; i < player.stage().steps.size(); i += 3) {
      player.press_key(std::to_string(i + 1));
      for (const std::string& name : handle_names(player)) {
        const double step = 0.1 * player.shown().steps[player.step()].view.radius;
        drag(player, name, {-step, 0.5 * step, 0.25 * step}, 0.02 * step);
        EXPECT_FALSE(player.shown().steps.empty()) << lesson.name << ' ' << name;
        player.press_key("r");
      }
    }
  }
}

}  // namespace
}  // namespace rayproof::viz
