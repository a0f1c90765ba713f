#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "generators/shapes/polygon/lifted.hpp"

namespace rayproof {
namespace {

using outline_layout::PolygonCase;

/// Twice the exact area of the parallelogram, for short numbers.
double orientation(const Vec2<double>& a, const Vec2<double>& b, const Vec2<double>& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

TEST(Outlines, HaveFromThreeVerticesToAHundred) {
  Random random(1);
  std::set<int> counts;
  for (int k = 0; k < 5000; ++k) counts.insert(vertex_count(random));
  EXPECT_EQ(*counts.begin(), 3);
  EXPECT_EQ(*counts.rbegin(), 100);
  EXPECT_EQ(counts.size(), 23U);
}

TEST(Outlines, AStarGoesRoundOnceWithoutTurningBack) {
  Random random(2);
  for (int k = 0; k < 200; ++k) {
    const Outline vertices = star(random, 12);
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
      EXPECT_GT(orientation({0, 0}, vertices[i], vertices[i + 1]), 0);
  }
}

TEST(Outlines, PaddingAddsRepeatedAndCollinearVerticesOnly) {
  Random random(3);
  for (int k = 0; k < 200; ++k) {
    const Outline vertices = scattered(random, 6, 4);
    const Outline more = padded(random, vertices);
    std::size_t next = 0;
    for (const Vec2<double>& v : more) {
      const bool is_next = next < 6 && v.x == vertices[next].x && v.y == vertices[next].y;
      if (is_next) ++next;
      const Vec2<double> a = vertices[next - 1], b = vertices[next % 6];
      EXPECT_EQ(orientation(a, b, v), 0);
    }
    EXPECT_EQ(next, 6U);
  }
}

TEST(Outlines, ALevelPointHasTheHeightOfAVertex) {
  Random random(4);
  for (int k = 0; k < 300; ++k) {
    const PolygonCase plan = outline_layout::level.plan(random);
    EXPECT_TRUE(std::any_of(plan.vertices.begin(), plan.vertices.end(),
                            [&](const Vec2<double>& v) { return v.y == plan.point.y; }));
  }
}

TEST(Outlines, ABoundaryPointIsExactlyOnASide) {
  Random random(5);
  for (int k = 0; k < 300; ++k) {
    const PolygonCase plan = outline_layout::boundary.plan(random);
    const std::size_t count = plan.vertices.size();
    bool on_a_line = false;
    for (std::size_t i = 0; i < count; ++i)
      on_a_line |= orientation(plan.vertices[i], plan.vertices[(i + 1) % count], plan.point) == 0;
    EXPECT_TRUE(on_a_line);
  }
}

TEST(LiftedPolygons, OfWholeNumbersLieInOnePlaneAndTheRayCrossesIt) {
  Random random(6);
  for (int k = 0; k < 300; ++k) {
    const Sheet sheet = polygon_family::whole_sheet(random);
    const glm::dvec3 normal = cross(sheet.u, sheet.v);
    EXPECT_NE(dot(normal, polygon_family::across(random, sheet)), 0);
    const Outline vertices = outline_layout::whole_outline(random);
    for (const glm::dvec3& vertex : polygon_family::lifted(sheet, vertices).vertices) {
      EXPECT_EQ(dot(normal, vertex - sheet.point), 0);
      EXPECT_EQ(rounded(Precision::float32, vertex), vertex);
    }
  }
}

}  // namespace
}  // namespace rayproof
