#include "case/each_number.hpp"

#include <gtest/gtest.h>

#include "case/case.hpp"

namespace rayproof {
namespace {

TEST(similar_shapes, grow_in_every_number_but_the_normal) {
  const auto solid = grown(Parallelepiped<double>{{1, 2, 3}, {{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}}}}, 2);
  EXPECT_EQ(solid.corner, glm::dvec3(2, 4, 6));
  EXPECT_EQ(solid.edges[2], glm::dvec3(0, 0, 6));

  const auto cylinder = grown(Cylinder<double>{1, 2, 3, true}, 0.5);
  EXPECT_EQ(cylinder.rx, 0.5);
  EXPECT_EQ(cylinder.height, 1.5);
  EXPECT_TRUE(cylinder.capped);

  const auto through_point = grown(PointNormalPlane{{1, 2, 3}, {0, 0, 1}}, 4);
  EXPECT_EQ(through_point.point, glm::dvec3(4, 8, 12));
  EXPECT_EQ(through_point.normal, glm::dvec3(0, 0, 1));
  const auto by_equation = grown(ImplicitPlane{{0, 1, 0}, -3}, 4);
  EXPECT_EQ(by_equation.normal, glm::dvec3(0, 1, 0));
  EXPECT_EQ(by_equation.d, -12);

  const auto in_the_plane = grown(PointAndPolygon<double>{{1, 2}, {{0, 0}, {1, 0}, {0, 3}}}, 2);
  EXPECT_EQ(in_the_plane.point.y, 4);
  EXPECT_EQ(in_the_plane.vertices[2].y, 6);
}

}  // namespace
}  // namespace rayproof
