#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "unit/viz/stage_data.hpp"
#include "viz/page/page.hpp"
#include "viz/scene/items.hpp"
#include "viz/scene/space.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace {

using namespace rayproof;
using namespace rayproof::viz;
using Json = nlohmann::json;

/// A stage of one step with these items, seen by a unit view.
Stage stage_with(Items items) {
  Stage stage;
  stage.steps.emplace_back();
  stage.steps.front().items = std::move(items);
  return stage;
}

TEST(SpaceData, LinesAreCutWhereTheyLeaveWhatIsBuilt) {
  const Stage stage = stage_with({segment(Role::edge, {-1, 0, 0}, {1e9, 0, 0})});
  const Space space = space_of(stage, 0);
  ASSERT_EQ(space.bodies.size(), 1U);
  EXPECT_EQ(space.bodies[0].pieces[0].front(), glm::dvec3(-1, 0, 0));
  EXPECT_NEAR(space.bodies[0].pieces[0].back().x, reach, 1e-6);
}

TEST(SpaceData, WhatIsOutOfReachOrNoNumberIsLeftOut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Stage stage = stage_with({point(Role::exact, {7, 0, 0}), point(Role::exact, {nan, 0, 0}, "t"),
                                  segment(Role::edge, {9, 9, 0}, {9, -9, 0}),
                                  viz::polygon(Role::surface, {{nan, 0, 0}, {1, 0, 0}, {0, 1, 0}})});
  const Space space = space_of(stage, 0);
  EXPECT_TRUE(space.bodies.empty());
  EXPECT_TRUE(space.labels.empty());
}

TEST(SpaceData, ABallTooSmallToSeeIsLeftOutAndAThinOneKeepsAllItsAxes) {
  const auto ball = [](double across, double high) {
    return StageItem{
        Role::surface, Form::ellipsoid, {{1, 0, 0}, {1 + across, 0, 0}, {1, across, 0}, {1, 0, high}}};
  };
  EXPECT_TRUE(space_of(stage_with({ball(1e-6, 1e-6)}), 0).bodies.empty());
  const Stage thin = stage_with({ball(1, 1e-6)});
  EXPECT_EQ(space_of(thin, 0).bodies.size(), 1U);
  // Three.js inverts the matrix of the axes.
  const Json space = Json::parse(space_json(thin));
  EXPECT_EQ(space["steps"][0]["bodies"][0]["points"].at(11), 1e-6);
}

TEST(SpaceData, AnArrowHasItsTipWhereItPoints) {
  const Space space = space_of(stage_with({arrow(Role::ray, {0, 0, 0}, {0, 1, 0})}), 0);
  ASSERT_TRUE(space.bodies.at(0).head);
  EXPECT_EQ(space.bodies[0].head->tip, glm::dvec3(0, 1, 0));
  EXPECT_LT(space.bodies[0].pieces[0].back().y, 1);
}

TEST(SpaceData, TheFloorLiesBelowAllOfIt) {
  const Stage stage =
      stage_with({{Role::surface, Form::ellipsoid, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}});
  const Space space = space_of(stage, 0);
  ASSERT_TRUE(space.floor);
  EXPECT_EQ(space.floor->axis, 2);
  EXPECT_LT(space.floor->shadows, -1);
  EXPECT_LT(space.floor->grid, space.floor->shadows);
  EXPECT_LT(space.floor->ground, space.floor->grid);
}

TEST(SpaceData, ALineOnASurfaceIsSolidInSpaceAndDashedInADrawing) {
  const Items items{segment(Role::surface, {-1, 0, 0}, {1, 0, 0}, {}, Pattern::dashed)};
  Stage stage = stage_with(items);
  EXPECT_EQ(space_of(stage, 0).bodies[0].pieces.size(), 1U);
  stage.camera.is_flat = true;
  EXPECT_GT(space_of(stage, 0).bodies[0].pieces.size(), 5U);
}

TEST(SpaceData, MarksAreSeenAllOfOneSize) {
  const Stage stage = stage_with({point(Role::exact, {0, 0, -2}), point(Role::exact, {0, 0, 1})});
  const Space space = space_of(stage, 0);
  const auto size = [&](const SpaceBody& mark) {
    return mark.radius / glm::dot(space.camera.eye() - mark.points[0], space.camera.toward);
  };
  EXPECT_NEAR(size(space.bodies.at(0)), size(space.bodies.at(1)), 1e-12);
}

TEST(SpaceData, AnOpenPolygonHasNoLineAroundIt) {
  const Stage stage = stage_with({open_polygon(Role::surface, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}),
                                  viz::polygon(Role::surface, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})});
  EXPECT_EQ(space_of(stage, 0).bodies.at(0).radius, 0);
  EXPECT_GT(space_of(stage, 0).bodies.at(1).radius, 0);
}

TEST(SpaceData, ADrawingFillsAFrameThatIsWiderThanItsView) {
  Stage stage = stage_with({segment(Role::edge, {-1.6, 0, 0}, {1.6, 0.5, 0})});
  stage.camera.is_flat = true;
  EXPECT_EQ(space_of(stage, 0).camera.half, view_margin);
  EXPECT_NEAR(space_of(stage, 0, 2.0).camera.half, 0.8 * view_margin, 1e-12);
  EXPECT_NEAR(space_of(stage, 0, 9.0).camera.half, 0.5 * view_margin, 1e-12);
}

/// Whether there is a null in it: JSON's word for what is no number.
bool has_null(const Json& json) {
  if (json.is_null()) return true;
  return json.is_structured() && std::any_of(json.begin(), json.end(), has_null);
}

TEST(SpaceJson, HoldsEveryStepOfEveryLessonInNumbers) {
  for (const Lesson& lesson : lessons()) {
    const Stage stage = stage_of(lesson, report_lesson);
    const Json data = Json::parse(space_json(stage));
    ASSERT_EQ(data["steps"].size(), stage.steps.size()) << lesson.name;
    EXPECT_FALSE(has_null(data)) << lesson.name;
    for (const Json& step : data["steps"]) EXPECT_FALSE(step["bodies"].empty()) << lesson.name;
  }
}

}  // namespace
