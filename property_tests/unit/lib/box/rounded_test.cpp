/// \file
/// What the correctly rounded ray/box method has over the others: exact verdicts beside edges and far from 1,
/// every t rounded once, and a transform composed exactly.

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <rayproof/box/methods.hpp>

namespace rayproof::box {
namespace {

template <class T>
class RoundedBox : public testing::Test {
 protected:
  const Ray<T> ray_{{T(0.5), T(0.5), -5}, {0, 0, 1}};
  const Box<T> box_{{0, 0, 0}, {1, 1, 1}};
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(RoundedBox, Precisions);

TYPED_TEST(RoundedBox, MissesWhatPaddedTakesForAHit) {
  const TypeParam above_one = std::nextafter(TypeParam(1), TypeParam(2));
  const Ray<TypeParam> ray{{-1, above_one - 1, TypeParam(0.5)}, {1, 1, 0}};  // y > 1 by the time x = 0
  EXPECT_GT(Padded::roots(ray, this->box_).discriminant, 0);
  EXPECT_EQ(Rounded::roots(ray, this->box_).discriminant, -1);
}

TYPED_TEST(RoundedBox, DistinguishesTwoHitsThatRoundToOneNumberFromATouch) {
  // In at x = 0 at t = 1, out at y = 1 at t = 1 + 2^-80.
  const TypeParam a_little = std::ldexp(TypeParam(1), -80);
  const Ray<TypeParam> ray{{-1, -a_little, TypeParam(0.5)}, {1, 1, 0}};
  const Roots<TypeParam> roots = Rounded::roots(ray, this->box_);
  EXPECT_GT(roots.discriminant, 0);
  EXPECT_EQ(roots.lo, 1);
  EXPECT_EQ(roots.hi, 1);
}

TEST(RoundedBoxInFloat, HoldsForTheLargestAndSmallestFloats) {
  const float largest = std::numeric_limits<float>::max();
  const float smallest = std::numeric_limits<float>::denorm_min();
  const Box<float> box{{-largest, -largest, -largest}, {largest, largest, largest}};
  const Ray<float> ray{{0, smallest, largest}, {smallest, 0, 0}};
  const Roots<float> roots = Rounded::roots(ray, box);
  EXPECT_GT(roots.discriminant, 0);
  EXPECT_EQ(roots.hi, infinity<float>);
  const Ray<float> passing{{0, 0, 0}, {largest, -largest, largest}};
  EXPECT_EQ(Rounded::roots(passing, box).hi, 1);
}

TYPED_TEST(RoundedBox, RoundsTiesToEven) {
  const TypeParam most =
      TypeParam(2) / std::numeric_limits<TypeParam>::epsilon();  // every second is a number
  const auto entry_from = [&](TypeParam z) {
    return Rounded::roots(Ray<TypeParam>{{0, 0, z}, {0, 0, 1}},
                          Box<TypeParam>{{-1, -1, most}, {1, 1, 2 * most}})
        .lo;
  };
  EXPECT_EQ(entry_from(-1), most);
  EXPECT_EQ(entry_from(-3), most + 4);
}

/// The map's third is no float: a ray that is rounded into object space first loses what decides.
TYPED_TEST(RoundedBox, ComposesATransformExactly) {
  for (const TypeParam scale : {TypeParam(3), TypeParam(-3)}) {
    const auto third = object_space(glm::scale(glm::mat<4, 4, TypeParam>(1), vec3<TypeParam>(scale)));
    const Box<TypeParam> box{{-1, -1, -1}, {1, 1, 1}};  // as large as 3 in the world, about the origin
    const auto at = [&](TypeParam y) {
      return roots_in_world<Rounded>(third, Ray<TypeParam>{{-6, y, 0}, {1, 1, 0}}, box);
    };
    EXPECT_EQ(at(0).discriminant, 0);  // touches the edge x = -3, y = 3
    EXPECT_EQ(at(0).lo, 3);
    EXPECT_GT(at(-std::numeric_limits<TypeParam>::min()).discriminant, 0);
    EXPECT_LT(at(std::numeric_limits<TypeParam>::min()).discriminant, 0);
    EXPECT_EQ(at(-6).lo, 3);
    EXPECT_EQ(at(-6).hi, 9);
  }
  const auto flat = object_space(glm::scale(glm::mat<4, 4, TypeParam>(1), vec3<TypeParam>(1, 1, 0)));
  EXPECT_FALSE(any(this->ray_, roots_in_world<Rounded>(flat, this->ray_, this->box_)));
}

class RoundedBoxInDouble : public testing::Test {
 protected:
  const Box<double> box_{{0, 0, 0}, {1, 1, 1}};
  [[nodiscard]] static Quick<double, Roots<double>> quick(const Ray<double>& ray, const Box<double>& box) {
    return rounded_roots(ray, Rounded::enclosed(ray, box));
  }
};

TEST_F(RoundedBoxInDouble, TrustsWhatIsClear) {
  EXPECT_TRUE(quick({{0.5, 0.5, -5}, {0.25, 0.125, 3}}, box_).is_sure);
  EXPECT_TRUE(quick({{0.5, 2, -5}, {0, 0, 1}}, box_).is_sure);    // parallel to faces, and outside
  EXPECT_TRUE(quick({{0.5, 0.5, -5}, {1, 0, 1}}, box_).is_sure);  // passes by
}

TEST_F(RoundedBoxInDouble, TrustsATOf0AtTheIntervalsEnd) {
  const auto on_face = quick({{0.5, 0.5, 0}, {0.25, 0.125, 3}}, box_);
  EXPECT_TRUE(on_face.is_sure);
  EXPECT_EQ(on_face.answer.lo, 0);
  EXPECT_FALSE(std::signbit(on_face.answer.lo));
}

TEST_F(RoundedBoxInDouble, DoesNotTrustEdgesEndsAndNumbersThatAreNotFinite) {
  const double nan = std::nan("");
  const double inf = infinity<double>;
  EXPECT_FALSE(quick({{-1, 0, 0.5}, {1, 1, 0}}, box_).is_sure);  // touches an edge
  EXPECT_FALSE(quick({{0.5, 0.5, -3}, {0, 0, 1}, 0, 3}, box_).is_sure);
  EXPECT_FALSE(quick({{0.5, 0.5, -3}, {0, 0, inf}}, box_).is_sure);
  EXPECT_FALSE(quick({{0.5, 0.5, -3}, {0, 0, 1}}, {{0, 0, 0}, {1, inf, 1}}).is_sure);
  EXPECT_FALSE(quick({{0.5, 0.5, -3}, {0, 0, 1}}, {{0, 0, 0}, {1, nan, 1}}).is_sure);
}

TEST_F(RoundedBoxInDouble, TakesARayWithANaNForAMiss) {
  EXPECT_EQ(quick({{std::nan(""), 0.5, -3}, {0, 0, 1}}, box_).answer.discriminant, -1);
}

}  // namespace
}  // namespace rayproof::box
