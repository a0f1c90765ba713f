/// \file
/// What the compensated ray/box method has over the others: exact verdicts beside edges and far from 1.

#include <gtest/gtest.h>

#include <rayproof/box/methods.hpp>

namespace rayproof::box {
namespace {

template <class T>
class CompensatedBox : public testing::Test {
 protected:
  const Ray<T> ray_{{T(0.5), T(0.5), -5}, {0, 0, 1}};
  const Box<T> box_{{0, 0, 0}, {1, 1, 1}};
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(CompensatedBox, Precisions);

TYPED_TEST(CompensatedBox, MissesWhatPaddedTakesForAHit) {
  const TypeParam above_one = std::nextafter(TypeParam(1), TypeParam(2));
  const Ray<TypeParam> ray{{-1, above_one - 1, TypeParam(0.5)}, {1, 1, 0}};  // y > 1 by the time x = 0
  EXPECT_GT(Padded::roots(ray, this->box_).discriminant, 0);
  EXPECT_EQ(Compensated::roots(ray, this->box_).discriminant, -1);
}

TYPED_TEST(CompensatedBox, DistinguishesTwoHitsThatRoundToOneNumberFromATouch) {
  // In at x = 0 at t = 1, out at y = 1 at t = 1 + 2^-80.
  const TypeParam a_little = std::ldexp(TypeParam(1), -80);
  const Ray<TypeParam> ray{{-1, -a_little, TypeParam(0.5)}, {1, 1, 0}};
  const Roots<TypeParam> roots = Compensated::roots(ray, this->box_);
  EXPECT_GT(roots.discriminant, 0);
  EXPECT_EQ(roots.lo, 1);
  EXPECT_EQ(roots.hi, 1);
}

TEST(CompensatedBoxInFloat, HoldsForTheLargestAndSmallestFloats) {
  const float largest = std::numeric_limits<float>::max();
  const float smallest = std::numeric_limits<float>::denorm_min();
  const Box<float> box{{-largest, -largest, -largest}, {largest, largest, largest}};
  const Ray<float> ray{{0, smallest, largest}, {smallest, 0, 0}};
  const Roots<float> roots = Compensated::roots(ray, box);
  EXPECT_GT(roots.discriminant, 0);
  EXPECT_EQ(roots.hi, infinity<float>);
  const Ray<float> passing{{0, 0, 0}, {largest, -largest, largest}};
  EXPECT_EQ(Compensated::roots(passing, box).hi, 1);
}

}  // namespace
}  // namespace rayproof::box
