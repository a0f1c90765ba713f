/// \file
/// What the polygons' formulas share: the order of axes, and the ends of sides.

#include <gtest/gtest.h>

#include <rayproof/formulas/largest_axis.hpp>
#include <rayproof/formulas/polygon_sides.hpp>

namespace rayproof {
namespace {

TEST(LargestAxisLast, KeepsTheAxesInACycle) {
  const vec3<double> v{10, 20, 30};
  EXPECT_EQ(LargestAxisLast<double>(vec3<double>{-3, 1, 2})(v), (vec3<double>{20, 30, 10}));
  EXPECT_EQ(LargestAxisLast<double>(vec3<double>{1, -3, 2})(v), (vec3<double>{30, 10, 20}));
  EXPECT_EQ(LargestAxisLast<double>(vec3<double>{1, 2, -3})(v), v);
}

TEST(LargestAxisLast, TakesTheLaterOfEqualAxes) {
  const vec3<double> v{10, 20, 30};
  EXPECT_EQ(LargestAxisLast<double>(vec3<double>{1, 1, 0})(v), (vec3<double>{30, 10, 20}));
  EXPECT_EQ(LargestAxisLast<double>(vec3<double>{1, 0, 1})(v), v);
  EXPECT_EQ(LargestAxisLast<double>(vec3<double>{0, 1, 1})(v), v);
}

TEST(ASidePassingALevel, HoldsItsLowerEndAndNotItsUpperOne) {
  EXPECT_TRUE(polygon::passes(1.0, 1.0, 2.0));
  EXPECT_TRUE(polygon::passes(1.0, 2.0, 1.0));
  EXPECT_FALSE(polygon::passes(2.0, 1.0, 2.0));
  EXPECT_FALSE(polygon::passes(2.0, 2.0, 1.0));
  EXPECT_FALSE(polygon::passes(1.0, 1.0, 1.0));
}

}  // namespace
}  // namespace rayproof
