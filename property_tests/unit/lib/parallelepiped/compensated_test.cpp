/// \file
/// What the compensated ray/parallelepiped method has over the others: exact verdicts of solids that rounding
/// flattens, beside edges and far from 1.

#include <gtest/gtest.h>

#include <rayproof/parallelepiped/methods.hpp>

namespace rayproof::parallelepiped {
namespace {

template <class T>
class CompensatedParallelepiped : public testing::Test {
 protected:
  /// (2, 0, 0), (1, 1, 0) and (0, 0, 1) from the corner (0, 0, 0).
  const Parallelepiped<T> leaning_{{0, 0, 0}, {vec3<T>{2, 0, 0}, vec3<T>{1, 1, 0}, vec3<T>{0, 0, 1}}};
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(CompensatedParallelepiped, Precisions);

TYPED_TEST(CompensatedParallelepiped, KeepsASolidThatRoundingFlattens) {
  // The base is (1+u, 1, 0) × (1, 1-u, 0) = -u²: in T it is 0, and the edges seem to lie in one plane.
  const TypeParam u = std::ldexp(TypeParam(1), sizeof(TypeParam) == 4 ? -13 : -27);
  const Parallelepiped<TypeParam> needle{
      {0, 0, 0}, {vec3<TypeParam>{1 + u, 1, 0}, vec3<TypeParam>{1, 1 - u, 0}, vec3<TypeParam>{0, 0, 1}}};
  const Ray<TypeParam> along{{1 + u, 1, -1}, {0, 0, 1}};
  EXPECT_EQ(UnitCube::roots(along, needle).discriminant, -1);
  EXPECT_EQ(Compensated::roots(along, needle).lo, 1);
  EXPECT_EQ(Compensated::roots(along, needle).hi, 2);
}

TYPED_TEST(CompensatedParallelepiped, DistinguishesTwoHitsThatRoundToOneNumberFromATouch) {
  const Ray<TypeParam> ray{{-1, 1, TypeParam(0.5)}, {1, -1, 0}};
  EXPECT_EQ(Compensated::roots(ray, this->leaning_).discriminant, 0);
  // With the corner moved to x = -2^-80 the ray enters at t = 1 - 2^-81 and leaves at y = 0 at t = 1.
  Parallelepiped<TypeParam> moved = this->leaning_;
  moved.corner.x = -std::ldexp(TypeParam(1), -80);
  const Roots<TypeParam> roots = Compensated::roots(ray, moved);
  EXPECT_GT(roots.discriminant, 0);
  EXPECT_EQ(roots.lo, 1);
  EXPECT_EQ(roots.hi, 1);
}

TYPED_TEST(CompensatedParallelepiped, MissesEdgesInOnePlane) {
  const Parallelepiped<TypeParam> flat{
      {0, 0, 0}, {vec3<TypeParam>{1, 0, 0}, vec3<TypeParam>{0, 1, 0}, vec3<TypeParam>{1, 1, 0}}};
  const Ray<TypeParam> ray{{TypeParam(0.5), TypeParam(0.5), -1}, {0, 0, 1}};
  EXPECT_EQ(Compensated::roots(ray, flat).discriminant, -1);
}

TEST(CompensatedParallelepipedInFloat, HoldsForTheLargestAndSmallestFloats) {
  const float largest = std::numeric_limits<float>::max();
  const float smallest = std::numeric_limits<float>::denorm_min();
  const Parallelepiped<float> solid{
      {-largest, -largest, 0},
      {glm::vec3{largest, 0, 0}, glm::vec3{0, largest, 0}, glm::vec3{0, 0, smallest}}};
  const Ray<float> ray{{-1, -1, -smallest}, {0, 0, smallest}};
  const Roots<float> roots = Compensated::roots(ray, solid);
  EXPECT_GT(roots.discriminant, 0);
  EXPECT_EQ(roots.lo, 1);
  EXPECT_EQ(roots.hi, 2);
}

}  // namespace
}  // namespace rayproof::parallelepiped
