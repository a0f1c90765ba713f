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

TYPED_TEST(NormalsOf, AMappedBoxAreThoseOfItsNearestFaceTurnedByTheMap) {
  using T = TypeParam;
  const Box<T> box{{0, 0, 0}, {2, 2, 2}};
  glm::mat<4, 4, T> map(1);  // twice as long along x, and moved by 10
  map[0].x = 2;
  map[3].x = 10;
  const std::optional space = object_space<T>(map);
  for (int axis = 0; axis < 3; ++axis)
    for (const T side : {T(-1), T(1)}) {
      vec3<T> from{12, 1, 1}, outward(0);
      outward[axis] = side;
      from += T(5) * outward;
      const Ray<T> ray{from, -outward};
      const T t = axis == 0 ? T(3) : T(4);
      EXPECT_EQ(normal_in_world(space, box, ray, t), outward);
    }
}

TYPED_TEST(NormalsOf, AShapeWithoutAMapAreItsOwn) {
  using T = TypeParam;
  const std::optional<ObjectSpace<T>> no_map;
  const Ray<T> ray{{0, 0, -5}, {0, 0, 1}};
  EXPECT_EQ(normal_in_world(no_map, Sphere<T>{{0, 0, 0}, 1}, ray, T(4)), (vec3<T>{0, 0, -1}));
  EXPECT_EQ(normal_in_world(no_map, Box<T>{{-1, -1, -1}, {1, 1, 1}}, ray, T(4)), (vec3<T>{0, 0, -1}));
}

TEST(NormalInWorld, OfABoxWhoseEdgeIsPassedBesideAFaceThatTheRayNearlyRunsAlong) {
  // By each face's own t, which says little of the one that is met at a small angle, it was another's.
  const glm::dmat4 map(-567.825862353766, 471.96876368697446, -88.35645581927972, 0,  //
                       376.6429086872584, 250.26174943701787, 169.1000765114173, 0,   //
                       1251.516, -617.68, -516.93, 0,                                 //
                       -1348.1716330534891, -2295.412068572545, 1017.4548765813153, 1);
  const Ray<double> ray{{29942.689336804877, -18021.616263243257, -10371.593515949673},
                        {-1877.2742006963795, 926.5162878444505, 775.4012072846547}};
  const glm::dvec3 normal = normal_in_world(std::optional(object_space<double>(map)),
                                            Box<double>{{-8, 0, 0}, {0, 1, 1}}, ray, 15.333333330245527);
  EXPECT_NEAR(normal.x, 0.536207837, 1e-6);
  EXPECT_NEAR(normal.y, 0.725788190, 1e-6);
  EXPECT_NEAR(normal.z, 0.430943916, 1e-6);
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
  const FlatHit<T> hit = triangle::Plucker::roots(ray, speck);
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

TYPED_TEST(NormalsOf, ACylinderFaceTheRayWhereRoundingLeavesThePointOnTheAxis) {
  using T = TypeParam;
  const T far = std::ldexp(T(1), std::numeric_limits<T>::digits);
  const Cylinder<T> pole{T(0.25), 1, 1, false};
  EXPECT_EQ(normal_at(pole, Ray<T>{{-far, 0, 0}, {far, 0, T(0.5)}}, T(1)), (vec3<T>{-1, 0, 0}));
  EXPECT_EQ(normal_at(pole, Ray<T>{{0, far, 0}, {0, -far, T(0.5)}}, T(1)), (vec3<T>{0, 1, 0}));
}

}  // namespace
}  // namespace rayproof
