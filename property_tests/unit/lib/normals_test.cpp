#include <gtest/gtest.h>

#include <rayproof/normals.hpp>
#include <rayproof/triangle/plucker.hpp>

namespace rayproof {
namespace {

template <class T>
class NormalsOf : public testing::Test {};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(NormalsOf, Numbers);

TYPED_TEST(NormalsOf, AFlatBoxAreThoseOfItsFaces) {
  using T = TypeParam;
  const Box<T> sheet{{-1, -1, 0}, {1, 1, 0}};
  const Ray<T> from_above{{T(0.9), 0, 3}, {0, 0, -1}}, from_below{{T(0.9), 0, -3}, {0, 0, 1}};
  EXPECT_EQ(normal_at(sheet, from_above, T(3)), (vec3<T>{0, 0, 1}));
  EXPECT_EQ(normal_at(sheet, from_below, T(3)), (vec3<T>{0, 0, -1}));
}

TYPED_TEST(NormalsOf, ABoxThinnerThanTheRoundingOfThePointAreThoseOfTheFaceThatIsMet) {
  using T = TypeParam;
  const T thin = std::numeric_limits<T>::epsilon();
  const Box<T> leaf{{1000, -thin, -1}, {1001, thin, 1}};
  const Ray<T> ray{{0, -5, 0}, {T(1000.5), 5, 0}};
  const T t = (-thin - ray.origin.y) / ray.direction.y;
  EXPECT_EQ(normal_at(leaf, ray, t), (vec3<T>{0, -1, 0}));
}

TYPED_TEST(NormalsOf, ABoxFromInsideAndInAFaceAreOutward) {
  using T = TypeParam;
  const Box<T> box{{0, 0, 0}, {2, 2, 2}};
  EXPECT_EQ(normal_at(box, Ray<T>{{1, 1, 1}, {0, 0, 1}}, T(1)), (vec3<T>{0, 0, 1}));
  EXPECT_EQ(normal_at(box, Ray<T>{{-1, 1, 2}, {1, 0, 0}}, T(1)), (vec3<T>{-1, 0, 0}));
}

TYPED_TEST(NormalsOf, ALowCylinderAreThoseOfItsCapsUpToTheRim) {
  using T = TypeParam;
  const T low = std::sqrt(std::numeric_limits<T>::epsilon());
  const Cylinder<T> coin{1, 1, low, true};
  const T x = 1 - low;
  EXPECT_EQ(normal_at(coin, Ray<T>{{x, 0, 5}, {0, 0, -1}}, T(5) - low), (vec3<T>{0, 0, 1}));
  EXPECT_EQ(normal_at(coin, Ray<T>{{x, 0, -5}, {0, 0, 1}}, T(5)), (vec3<T>{0, 0, -1}));
  EXPECT_EQ(normal_at(coin, Ray<T>{{5, 0, low / 2}, {-1, 0, 0}}, T(4)), (vec3<T>{1, 0, 0}));
}

TYPED_TEST(NormalsOf, AParallelepipedAreOutwardWhicheverHandItsEdgesHave) {
  using T = TypeParam;
  const Parallelepiped<T> right{{0, 0, 0}, {{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}}};
  const Parallelepiped<T> left{{0, 0, 0}, {{{0, 2, 0}, {2, 0, 0}, {0, 0, 2}}}};
  for (const auto& solid : {right, left}) {
    EXPECT_EQ(normal_at(solid, vec3<T>{1, 1, 2}), (vec3<T>{0, 0, 1}));
    EXPECT_EQ(normal_at(solid, vec3<T>{1, 0, 1}), (vec3<T>{0, -1, 0}));
    EXPECT_EQ(normal_at(solid, vec3<T>{0, 1, 1}), (vec3<T>{-1, 0, 0}));
  }
}

TYPED_TEST(NormalsOf, ANeedleAreThoseOfTheFaceThatIsMet) {
  using T = TypeParam;
  const T thin = std::sqrt(std::numeric_limits<T>::epsilon());
  const Parallelepiped<T> needle{{0, 0, 0}, {{{1, 0, 0}, {1, thin, 0}, {0, 0, 1}}}};
  const vec3<T> normal = normal_at(needle, Ray<T>{{T(1), thin / 2, 3}, {0, 0, -1}}, T(2));
  EXPECT_EQ(normal.x, 0);
  EXPECT_EQ(normal.y, 0);
  EXPECT_NEAR(normal.z, 1, std::numeric_limits<T>::epsilon());
}

TYPED_TEST(NormalsOf, ATriangleSmallerThanItsRoundingIsMissed) {
  using T = TypeParam;
  const T far = std::ldexp(T(1), std::numeric_limits<T>::digits);
  const Triangle<T> speck{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Ray<T> ray{{-far, 5 * far, 0}, {1, -5, 0}};
  const FlatHit<T> hit = triangle::Pluecker::roots(ray, speck);
  EXPECT_TRUE(std::isnan(hit.lo));
}

TYPED_TEST(NormalsOf, ASphereAreOfUnitLengthThoughThePointIsAsGoodAsItsCentre) {
  using T = TypeParam;
  for (const T off : {std::numeric_limits<T>::denorm_min(), std::numeric_limits<T>::min(), T(1e-21)})
    EXPECT_EQ(normal_at(Sphere<T>{{0, 0, 0}, 1}, vec3<T>{0, -off, 0}), (vec3<T>{0, -1, 0}));
  const T huge = std::numeric_limits<T>::max();
  EXPECT_NEAR(unit_vector<T>({huge, 0, -huge}).x, std::sqrt(T(0.5)), 4 * std::numeric_limits<T>::epsilon());
  EXPECT_TRUE(std::isnan(normal_at(Sphere<T>{{1, 2, 3}, 0}, vec3<T>{1, 2, 3}).x));
}

}  // namespace
}  // namespace rayproof
