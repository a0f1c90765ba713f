/// \file
/// What the correctly rounded ray/cylinder method has over the others: exact verdicts beside tangents and
/// rims, and every t rounded once.

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <rayproof/cylinder/methods.hpp>

namespace rayproof::cylinder {
namespace {

template <class T>
class RoundedCylinder : public testing::Test {
 protected:
  const Cylinder<T> capped_{2, 1, 4, true};
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(RoundedCylinder, Precisions);

TYPED_TEST(RoundedCylinder, DistinguishesATangentFromItsNeighbours) {
  const TypeParam one = 1;
  const auto at = [&](TypeParam y) {
    return Rounded::roots(Ray<TypeParam>{{-1000, y, 1}, {1, 0, 0}}, this->capped_);
  };
  EXPECT_EQ(at(one).discriminant, 0);
  EXPECT_EQ(at(one).lo, 1000);
  EXPECT_EQ(at(std::nextafter(one, 2 * one)).discriminant, -1);
  const Roots<TypeParam> inside = at(std::nextafter(one, 0 * one));
  EXPECT_GT(inside.discriminant, 0);
  EXPECT_LE(inside.lo, 1000);
  EXPECT_GE(inside.hi, 1000);
}

TYPED_TEST(RoundedCylinder, TouchesAnObliqueTangentOnce) {
  // At (2·0.6, 0.8) the tangent runs along (-1.6, 0.6); times 5, in whole numbers, with radii 10 and 5.
  const Ray<TypeParam> ray{{6 + 8 * 3, 4 - 3 * 3, 1}, {-8, 3, 0}};
  const Roots<TypeParam> roots = Rounded::roots(ray, Cylinder<TypeParam>{10, 5, 4, false});
  EXPECT_EQ(roots.discriminant, 0);
  EXPECT_EQ(roots.lo, 3);
  EXPECT_EQ(roots.hi, 3);
}

TYPED_TEST(RoundedCylinder, DistinguishesARimThatIsTouchedFromItsNeighbours) {
  const auto from = [&](TypeParam height) {
    return Rounded::roots(Ray<TypeParam>{{-3, 0, height}, {1, 0, -1}}, this->capped_);
  };
  EXPECT_TRUE(std::isnan(from(1).lo));
  EXPECT_EQ(from(1).hi, 1);
  EXPECT_EQ(from(std::nextafter(TypeParam(1), TypeParam(0))).discriminant, -1);
  const Roots<TypeParam> above = from(std::nextafter(TypeParam(1), TypeParam(2)));
  EXPECT_EQ(above.lo, 1);
  EXPECT_EQ(above.hi, std::nextafter(TypeParam(1), TypeParam(2)));
}

TYPED_TEST(RoundedCylinder, DistinguishesTwoHitsThatRoundToOneNumberFromATangent) {
  const TypeParam far = std::ldexp(TypeParam(1), 30);
  for (const auto& cylinder : {this->capped_, Cylinder<TypeParam>{2, 1, 4, false}}) {
    const Ray<TypeParam> ray{{-far, std::nextafter(TypeParam(1), TypeParam(0)), 1}, {1, 0, 0}};
    const Roots<TypeParam> roots = Rounded::roots(ray, cylinder);
    EXPECT_GT(roots.discriminant, 0);
    EXPECT_EQ(roots.lo, far);
    EXPECT_EQ(roots.hi, far);
  }
}

TYPED_TEST(RoundedCylinder, MakesNothingOfRadiiOfZeroAndNegativeHeights) {
  const Ray<TypeParam> ray{{-3, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(Rounded::roots(ray, Cylinder<TypeParam>{0, 1, 1, true}).discriminant, -1);
  EXPECT_EQ(Rounded::roots(ray, Cylinder<TypeParam>{1, 0, 1, true}).discriminant, -1);
  EXPECT_EQ(Rounded::roots(ray, Cylinder<TypeParam>{1, 1, -1, true}).discriminant, -1);
}

TEST(RoundedCylinderInFloat, HoldsForTheLargestAndSmallestFloats) {
  const float largest = std::numeric_limits<float>::max();
  const float smallest = std::numeric_limits<float>::denorm_min();
  const Cylinder<float> wide{largest, smallest, largest, true};
  const Ray<float> across{{0, 0, 0}, {largest, 0, largest}};
  EXPECT_EQ(Rounded::roots(across, wide).lo, 0);
  EXPECT_EQ(Rounded::roots(across, wide).hi, 1);
  const Ray<float> slow{{0, 0, 1}, {smallest, 0, 0}};
  EXPECT_EQ(Rounded::roots(slow, wide).hi, infinity<float>);
  EXPECT_EQ(Rounded::roots(slow, wide).lo, -infinity<float>);
}

TYPED_TEST(RoundedCylinder, RoundsTiesToEven) {
  using T = TypeParam;
  const T most = T(2) / std::numeric_limits<T>::epsilon();  // every second whole number from here is a number
  for (const bool is_capped : {false, true}) {
    const auto exit_from = [&](T x) {
      return Rounded::roots(Ray<T>{{x, 0, 1}, {1, 0, 0}}, Cylinder<T>{most, 1, 4, is_capped}).hi;
    };
    EXPECT_EQ(exit_from(-1), most);
    EXPECT_EQ(exit_from(-3), most + 4);
  }
}

/// The map's third is no float: a ray that is rounded into object space first loses what decides.
TYPED_TEST(RoundedCylinder, ComposesATransformExactly) {
  using T = TypeParam;
  for (const T scale : {T(3), T(-3)}) {
    const auto third = object_space(glm::scale(glm::mat<4, 4, T>(1), vec3<T>(scale)));
    const auto across = [&](T y, bool is_capped) {  // at the height 1, 6 by 3 in the world
      return roots_in_world<Rounded>(third, Ray<T>{{-30, y, scale}, {1, 0, 0}},
                                     Cylinder<T>{2, 1, 4, is_capped});
    };
    for (const bool is_capped : {false, true}) {
      EXPECT_EQ(across(3, is_capped).discriminant, 0);
      EXPECT_EQ(across(3, is_capped).lo, 30);
      EXPECT_GT(across(std::nextafter(T(3), T(0)), is_capped).discriminant, 0);
      EXPECT_LT(across(std::nextafter(T(3), T(4)), is_capped).discriminant, 0);
      EXPECT_EQ(across(0, is_capped).lo, 24);
      EXPECT_EQ(across(0, is_capped).hi, 36);
    }
    const auto past_the_rim = [&](T x) {
      return roots_in_world<Rounded>(third, Ray<T>{{x, 0, 3 * scale}, {-1, 0, scale}},
                                     Cylinder<T>{2, 1, 4, true});
    };
    EXPECT_TRUE(std::isnan(past_the_rim(7).lo));
    EXPECT_EQ(past_the_rim(7).hi, 1);  // touches it at x = 6
    EXPECT_LT(past_the_rim(std::nextafter(T(7), T(8))).discriminant, 0);
    EXPECT_LT(past_the_rim(std::nextafter(T(7), T(6))).lo, 1);
    const Ray<T> along{{1, 1, 0}, {0, 0, scale}};
    EXPECT_EQ(roots_in_world<Rounded>(third, along, Cylinder<T>{2, 1, 4, true}).hi, 4);
    EXPECT_FALSE(any(along, roots_in_world<Rounded>(third, along, Cylinder<T>{2, 1, 4, false})));
  }
  const auto flat = object_space(glm::scale(glm::mat<4, 4, T>(1), vec3<T>(1, 1, 0)));
  const Ray<T> ray{{-3, 0, 0}, {1, 0, 0}};
  EXPECT_FALSE(any(ray, roots_in_world<Rounded>(flat, ray, this->capped_)));
}

class RoundedCylinderInDouble : public testing::TestWithParam<bool> {
 protected:
  [[nodiscard]] static auto quick(const Ray<double>& ray, double height = 4) {
    const Cylinder<double> cylinder{2, 1, height, GetParam()};
    return rounded_roots(ray, Rounded::enclosed(ray, cylinder));
  }
};
INSTANTIATE_TEST_SUITE_P(OpenAndCapped, RoundedCylinderInDouble, testing::Bool(),
                         [](const auto& test) { return test.param ? "Capped" : "Open"; });

TEST_P(RoundedCylinderInDouble, TrustsWhatIsClear) {
  EXPECT_TRUE(quick({{-5, 0.1, 1}, {1, 0.01, 0.02}}).is_sure);  // through the side twice
  EXPECT_TRUE(quick({{0.1, 0.2, 1}, {0.5, 0.01, 1}}).is_sure);  // along the axis, nearly
  EXPECT_TRUE(quick({{-5, 0.1, 1}, {1, 0.01, 0}}).is_sure);     // parallel to both ends
  EXPECT_TRUE(quick({{-5, 3, 1}, {1, 0.01, 0.02}}).is_sure);    // beside the side
  EXPECT_TRUE(quick({{-5, 0.1, 5}, {1, 0.01, 0}}).is_sure);     // above
  EXPECT_TRUE(quick({{-5, 0.1, 5}, {1, 0.01, 0.02}}).is_sure);
}

TEST_P(RoundedCylinderInDouble, GivesOneHitOfTheSideAlone) {
  const Ray<double> ray{{-5, 0, 1}, {1, 0, 0.5}};  // into the side at t = 3, through the upper end at t = 6
  const auto [roots, is_sure] = quick(ray);
  EXPECT_TRUE(is_sure);
  EXPECT_GT(roots.discriminant, 0);
  EXPECT_EQ(std::isnan(roots.lo), !GetParam());
  EXPECT_EQ(roots.hi, GetParam() ? 6 : 3);
  const Cylinder<double> cylinder{2, 1, 4, GetParam()};
  const auto first = rounded_nearest(ray, Rounded::enclosed(ray, cylinder));
  EXPECT_TRUE(first.is_sure);
  EXPECT_EQ(first.answer, 3);
}

TEST_P(RoundedCylinderInDouble, DoesNotTrustTangentsRimsEndsAndNumbersThatAreNotFinite) {
  EXPECT_FALSE(quick({{-5, 1, 1}, {1, 0, 0}}).is_sure);
  EXPECT_FALSE(quick({{-3, 0, 1}, {1, 0, -1}}).is_sure);       // touches the rim at (-2, 0, 0)
  EXPECT_FALSE(quick({{-5, 0, 1}, {1, 0, 0}, 0, 3}).is_sure);  // ends on the side
  EXPECT_FALSE(quick({{0, 0, 1}, {0, 0, 1}}).is_sure);
  EXPECT_FALSE(quick({{-5, 0.1, 1}, {1, 0, 0.01}}, infinity<double>).is_sure);
  EXPECT_FALSE(quick({{-5, std::nan(""), 1}, {1, 0, 0}}).is_sure);
  EXPECT_FALSE(quick({{-5, 0.1, 1}, {infinity<double>, 0, 0}}).is_sure);
  EXPECT_FALSE(quick({{-5, 0.1, std::nan("")}, {1, 0, 1}}).is_sure);
}

}  // namespace
}  // namespace rayproof::cylinder
