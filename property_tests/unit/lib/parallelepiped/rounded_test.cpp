/// \file
/// What the correctly rounded ray/parallelepiped method has over the others: exact verdicts of solids that
/// rounding flattens, beside edges and far from 1, every t rounded once, and a transform composed exactly.

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <rayproof/parallelepiped/methods.hpp>

namespace rayproof::parallelepiped {
namespace {

template <class T>
class RoundedParallelepiped : public testing::Test {
 protected:
  /// (2, 0, 0), (1, 1, 0) and (0, 0, 1) from the corner (0, 0, 0).
  const Parallelepiped<T> leaning_{{0, 0, 0}, {vec3<T>{2, 0, 0}, vec3<T>{1, 1, 0}, vec3<T>{0, 0, 1}}};
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(RoundedParallelepiped, Precisions);

TYPED_TEST(RoundedParallelepiped, KeepsASolidThatRoundingFlattens) {
  // The base is (1+u, 1, 0) × (1, 1-u, 0) = -u²: in T it is 0, and the edges seem to lie in one plane.
  const TypeParam u = std::ldexp(TypeParam(1), sizeof(TypeParam) == 4 ? -13 : -27);
  const Parallelepiped<TypeParam> needle{
      {0, 0, 0}, {vec3<TypeParam>{1 + u, 1, 0}, vec3<TypeParam>{1, 1 - u, 0}, vec3<TypeParam>{0, 0, 1}}};
  const Ray<TypeParam> along{{1 + u, 1, -1}, {0, 0, 1}};
  EXPECT_EQ(UnitCube::roots(along, needle).discriminant, -1);
  EXPECT_EQ(Rounded::roots(along, needle).lo, 1);
  EXPECT_EQ(Rounded::roots(along, needle).hi, 2);
}

TYPED_TEST(RoundedParallelepiped, DistinguishesTwoHitsThatRoundToOneNumberFromATouch) {
  const Ray<TypeParam> ray{{-1, 1, TypeParam(0.5)}, {1, -1, 0}};
  EXPECT_EQ(Rounded::roots(ray, this->leaning_).discriminant, 0);
  // With the corner moved to x = -2^-80 the ray enters at t = 1 - 2^-81 and leaves at y = 0 at t = 1.
  Parallelepiped<TypeParam> moved = this->leaning_;
  moved.corner.x = -std::ldexp(TypeParam(1), -80);
  const Roots<TypeParam> roots = Rounded::roots(ray, moved);
  EXPECT_GT(roots.discriminant, 0);
  EXPECT_EQ(roots.lo, 1);
  EXPECT_EQ(roots.hi, 1);
}

TYPED_TEST(RoundedParallelepiped, MissesEdgesInOnePlane) {
  const Parallelepiped<TypeParam> flat{
      {0, 0, 0}, {vec3<TypeParam>{1, 0, 0}, vec3<TypeParam>{0, 1, 0}, vec3<TypeParam>{1, 1, 0}}};
  const Ray<TypeParam> ray{{TypeParam(0.5), TypeParam(0.5), -1}, {0, 0, 1}};
  EXPECT_EQ(Rounded::roots(ray, flat).discriminant, -1);
}

TEST(RoundedParallelepipedInFloat, HoldsForTheLargestAndSmallestFloats) {
  const float largest = std::numeric_limits<float>::max();
  const float smallest = std::numeric_limits<float>::denorm_min();
  const Parallelepiped<float> solid{
      {-largest, -largest, 0},
      {glm::vec3{largest, 0, 0}, glm::vec3{0, largest, 0}, glm::vec3{0, 0, smallest}}};
  const Ray<float> ray{{-1, -1, -smallest}, {0, 0, smallest}};
  const Roots<float> roots = Rounded::roots(ray, solid);
  EXPECT_GT(roots.discriminant, 0);
  EXPECT_EQ(roots.lo, 1);
  EXPECT_EQ(roots.hi, 2);
}

TYPED_TEST(RoundedParallelepiped, RoundsTiesToEven) {
  using T = TypeParam;
  const T most = T(2) / std::numeric_limits<T>::epsilon();  // every second whole number from here is a number
  const Parallelepiped<T> far{{-1, -1, most}, {vec3<T>{2, 0, 0}, vec3<T>{0, 2, 0}, vec3<T>{1, 1, most}}};
  EXPECT_EQ(Rounded::roots(Ray<T>{{0, 0, -1}, {0, 0, 1}}, far).lo, most);
  EXPECT_EQ(Rounded::roots(Ray<T>{{0, 0, -3}, {0, 0, 1}}, far).lo, most + 4);
}

/// The map's third is no float: a ray that is rounded into object space first loses what decides.
TYPED_TEST(RoundedParallelepiped, ComposesATransformExactly) {
  using T = TypeParam;
  for (const T scale : {T(3), T(-3)}) {
    const auto third = object_space(glm::scale(glm::mat<4, 4, T>(1), vec3<T>(3, 3, scale)));
    const auto at = [&](T y) {
      return roots_in_world<Rounded>(third, Ray<T>{{9, y, scale / 2}, {-1, 0, 0}}, this->leaning_);
    };
    EXPECT_EQ(at(3).lo, 0);  // along the face y = 1
    EXPECT_EQ(at(3).hi, 6);
    EXPECT_EQ(at(std::nextafter(T(3), T(4))).discriminant, -1);
    EXPECT_EQ(at(1).lo, 2);
    EXPECT_EQ(at(1).hi, 8);
  }
  const auto flat = object_space(glm::scale(glm::mat<4, 4, T>(1), vec3<T>(1, 1, 0)));
  const Ray<T> ray{{1, T(0.5), -1}, {0, 0, 1}};
  EXPECT_FALSE(any(ray, roots_in_world<Rounded>(flat, ray, this->leaning_)));
}

TEST(RoundedParallelepipedInDouble, TrustsOnlyWhatIsClear) {
  const Parallelepiped<double> leaning{{0, 0, 0},
                                       {glm::dvec3{2, 0, 0}, glm::dvec3{1, 1, 0}, glm::dvec3{0, 0, 1}}};
  const auto is_sure = [&](const Ray<double>& ray) {
    return rounded_roots(ray, Rounded::enclosed(ray, Rounded::prepared(leaning))).is_sure;
  };
  EXPECT_TRUE(is_sure({{1, 0.5, -1}, {0.25, 0.125, 1}}));
  EXPECT_TRUE(is_sure({{9, 0.5, -1}, {0.25, 0.125, 1}}));  // passes by
  EXPECT_TRUE(is_sure({{-1.1, 0.3, 0.5}, {0.7, 0, 0}}));   // parallel to faces, and inside them
  EXPECT_TRUE(is_sure({{-1.1, 2, 0.5}, {0.7, 0, 0}}));     // and outside
  EXPECT_FALSE(is_sure({{-1, 1, 0.5}, {0.5, 0, 0}}));      // along a face
  EXPECT_FALSE(is_sure({{-1, 1, 0.5}, {1, -1, 0}}));       // touches an edge
  EXPECT_FALSE(is_sure({{1, 0.5, -1}, {0, 0, 1}, 0, 1}));  // ends on a face
  EXPECT_FALSE(is_sure({{1, 0.5, 0.5}, {0, 0, 0}}));
  EXPECT_FALSE(is_sure({{1, 0.5, -infinity<double>}, {0, 0, 1}}));
  EXPECT_FALSE(is_sure({{1, 0.5, -1}, {0, 0, infinity<double>}}));
  EXPECT_FALSE(is_sure({{1, std::nan(""), -1}, {0, 0, 1}}));
}

}  // namespace
}  // namespace rayproof::parallelepiped
