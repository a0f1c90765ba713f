/// \file
/// What the compensated ray/cylinder method has over the others: exact verdicts beside tangents and rims.

#include <gtest/gtest.h>

#include <rayproof/cylinder/methods.hpp>

namespace rayproof::cylinder {
namespace {

template <class T>
class CompensatedCylinder : public testing::Test {
 protected:
  const Cylinder<T> capped_{2, 1, 4, true};
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(CompensatedCylinder, Precisions);

TYPED_TEST(CompensatedCylinder, DistinguishesATangentFromItsNeighbours) {
  const TypeParam one = 1;
  const auto at = [&](TypeParam y) {
    return Compensated::roots(Ray<TypeParam>{{-1000, y, 1}, {1, 0, 0}}, this->capped_);
  };
  EXPECT_EQ(at(one).discriminant, 0);
  EXPECT_EQ(at(one).lo, 1000);
  EXPECT_EQ(at(std::nextafter(one, 2 * one)).discriminant, -1);
  const Roots<TypeParam> inside = at(std::nextafter(one, 0 * one));
  EXPECT_GT(inside.discriminant, 0);
  EXPECT_LE(inside.lo, 1000);
  EXPECT_GE(inside.hi, 1000);
}

TYPED_TEST(CompensatedCylinder, TouchesAnObliqueTangentOnce) {
  // At (2·0.6, 0.8) the tangent runs along (-1.6, 0.6); times 5, in whole numbers, with radii 10 and 5.
  const Ray<TypeParam> ray{{6 + 8 * 3, 4 - 3 * 3, 1}, {-8, 3, 0}};
  const Roots<TypeParam> roots = Compensated::roots(ray, Cylinder<TypeParam>{10, 5, 4, false});
  EXPECT_EQ(roots.discriminant, 0);
  EXPECT_EQ(roots.lo, 3);
  EXPECT_EQ(roots.hi, 3);
}

TYPED_TEST(CompensatedCylinder, DistinguishesARimThatIsTouchedFromItsNeighbours) {
  const auto from = [&](TypeParam height) {
    return Compensated::roots(Ray<TypeParam>{{-3, 0, height}, {1, 0, -1}}, this->capped_);
  };
  EXPECT_TRUE(std::isnan(from(1).lo));
  EXPECT_EQ(from(1).hi, 1);
  EXPECT_EQ(from(std::nextafter(TypeParam(1), TypeParam(0))).discriminant, -1);
  const Roots<TypeParam> above = from(std::nextafter(TypeParam(1), TypeParam(2)));
  EXPECT_EQ(above.lo, 1);
  EXPECT_EQ(above.hi, std::nextafter(TypeParam(1), TypeParam(2)));
}

TYPED_TEST(CompensatedCylinder, DistinguishesTwoHitsThatRoundToOneNumberFromATangent) {
  const TypeParam far = std::ldexp(TypeParam(1), 30);
  for (const auto& cylinder : {this->capped_, Cylinder<TypeParam>{2, 1, 4, false}}) {
    const Ray<TypeParam> ray{{-far, std::nextafter(TypeParam(1), TypeParam(0)), 1}, {1, 0, 0}};
    const Roots<TypeParam> roots = Compensated::roots(ray, cylinder);
    EXPECT_GT(roots.discriminant, 0);
    EXPECT_EQ(roots.lo, far);
    EXPECT_EQ(roots.hi, far);
  }
}

TYPED_TEST(CompensatedCylinder, MakesNothingOfRadiiOfZeroAndNegativeHeights) {
  const Ray<TypeParam> ray{{-3, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(Compensated::roots(ray, Cylinder<TypeParam>{0, 1, 1, true}).discriminant, -1);
  EXPECT_EQ(Compensated::roots(ray, Cylinder<TypeParam>{1, 0, 1, true}).discriminant, -1);
  EXPECT_EQ(Compensated::roots(ray, Cylinder<TypeParam>{1, 1, -1, true}).discriminant, -1);
}

TEST(CompensatedCylinderInFloat, HoldsForTheLargestAndSmallestFloats) {
  const float largest = std::numeric_limits<float>::max();
  const float smallest = std::numeric_limits<float>::denorm_min();
  const Cylinder<float> wide{largest, smallest, largest, true};
  const Ray<float> across{{0, 0, 0}, {largest, 0, largest}};
  EXPECT_EQ(Compensated::roots(across, wide).lo, 0);
  EXPECT_EQ(Compensated::roots(across, wide).hi, 1);
  const Ray<float> slow{{0, 0, 1}, {smallest, 0, 0}};
  EXPECT_EQ(Compensated::roots(slow, wide).hi, infinity<float>);
  EXPECT_EQ(Compensated::roots(slow, wide).lo, -infinity<float>);
}

}  // namespace
}  // namespace rayproof::cylinder
