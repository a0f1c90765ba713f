/// \file
/// The nearest of two roots and any of them, where an interval holds one alone or may hold it.

#include <gtest/gtest.h>

#include <rayproof/formulas/rounding_test.hpp>

namespace rayproof {
namespace {

TEST(AnyOfTwoRoots, IsTheFartherOneWhereTheNearerLiesBeforeTheInterval) {
  const Ray<double> ray{{0, 0, 0}, {0, 0, 1}, 0, 5};
  EXPECT_TRUE(any(ray, Roots<double>{1, -1, 1}));
  EXPECT_TRUE(any(ray, Roots<double>{1, 1, 9}));
  EXPECT_FALSE(any(ray, Roots<double>{1, -1, 9}));
  EXPECT_FALSE(any(ray, Roots<double>{1, -2, -1}));
}

TEST(TheNearestRootRounded, IsNotSureWhereTheLowerOneMayLieOnEitherSideOfAnEnd) {
  const Ray<double> ray{{0, 0, 0}, {0, 0, 1}, 1, infinity<double>};
  const Enclosed<double> beside{{1, 1 - 0x1p-53, 2}, 0x1p-50, 0, true};
  EXPECT_FALSE(rounded_nearest(ray, beside).is_sure);
  const Enclosed<double> before{{1, 1 - 0x1p-40, 2}, 0x1p-50, 0, true};
  EXPECT_TRUE(rounded_nearest(ray, before).is_sure);
  EXPECT_EQ(rounded_nearest(ray, before).answer, 2);
}

TEST(TheNearestRootRounded, IsTestedByTheErrorOfTheRootThatIsTaken) {
  const Ray<double> ray{{0, 0, 0}, {0, 0, 1}, 0, infinity<double>};
  const double near_middle_of_floats = 1 + 0x1p-24 - 0x1p-50;
  EXPECT_FALSE(
      rounded_nearest(ray, Enclosed<double>{{1, -1, near_middle_of_floats}, 0, 0x1p-48, true}).is_sure);
  EXPECT_TRUE(rounded_nearest(ray, Enclosed<double>{{1, -1, near_middle_of_floats}, 0.5, 0, true}).is_sure);
}

}  // namespace
}  // namespace rayproof
