#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <rayproof/sphere/centred.hpp>
#include <rayproof/transform.hpp>

namespace rayproof {
namespace {

TEST(Transform, TheIdentityChangesNothing) {
  const Ray<double> ray{{1, 2, 3}, {4, 5, 6}, -1, 7};
  const Ray<double> same = to_object(object_space(glm::dmat4(1)), ray);
  EXPECT_EQ(same.origin, ray.origin);
  EXPECT_EQ(same.direction, ray.direction);
  EXPECT_EQ(same.t_min, -1);
  EXPECT_EQ(same.t_max, 7);
}

TEST(Transform, ATranslationMovesPointsAndLeavesVectors) {
  const auto space = object_space(glm::translate(glm::dmat4(1), {10, 20, 30}));
  EXPECT_EQ(space.point({11, 22, 33}), glm::dvec3(1, 2, 3));
  EXPECT_EQ(space.direction({11, 22, 33}), glm::dvec3(11, 22, 33));
}

TEST(Transform, KeepsTWhenTheDirectionIsNotMadeAUnitVector) {
  const auto space = object_space(glm::scale(glm::dmat4(1), {1, 1, 2}));
  const Ray<double> world{{0, 0, -5}, {0, 0, 1}};
  const Sphere<double> unit{{0, 0, 0}, 1};
  EXPECT_EQ(nearest(world, sphere::Centred::roots(to_object(space, world), unit)), 3);
}

TEST(Transform, BendsNormalsByTheInverseTranspose) {
  const auto space = object_space(glm::scale(glm::dmat4(1), {2, 1, 1}));
  const double h = std::sqrt(0.5);
  const glm::dvec3 normal = normal_to_world(space, {h, h, 0});
  // On the ellipsoid x²/4 + y² = 1 the normal at (√2, 1/√2) is along (1/2, 1).
  EXPECT_NEAR(normal.y / normal.x, 2, 1e-15);
  EXPECT_NEAR(dot(normal, normal), 1, 1e-15);
}

TEST(Transform, InvertsANearlySingularMatrixToFewUlps) {
  glm::dmat4 m(1);
  m[0] = {0, 0, 1, 0};
  m[1] = {1 + 0x1p-30, 1, 0, 0};
  m[2] = {1, 1 - 0x1p-30, 0, 0};  // a cofactor of -2^-60, from two products that agree in 60 digits
  const auto space = object_space(m);
  EXPECT_EQ(space.row_x.z, 1);
  EXPECT_EQ(space.row_y.x, (1 - 0x1p-30) / -0x1p-60);
  EXPECT_EQ(space.row_y.y, 0x1p+60);
}

/// A map of whole numbers whose determinant is exactly `sign`, while the products that sum to it grow with n.
template <class T>
glm::mat<4, 4, T> map_of_determinant(int sign, T n) {
  const glm::mat<3, 3, T> lower{{T(sign), n, -n}, {0, 1, n - 1}, {0, 0, 1}};
  const glm::mat<3, 3, T> upper{{1, 0, 0}, {n + 1, 1, 0}, {n, -n, 1}};
  return glm::mat<4, 4, T>(lower * upper);
}

template <class T>
class TransformIn : public testing::Test {};
using Floats = testing::Types<float, double>;
TYPED_TEST_SUITE(TransformIn, Floats);

TYPED_TEST(TransformIn, NormalsKeepTheirSideHoweverNearTheMapIsToASingularOne) {
  using T = TypeParam;
  for (const int sign : {1, -1}) {
    for (T n = 1; n * n * n < T(1) / unit_roundoff<T>; n += 1 + std::floor(n / 8)) {
      const auto map = map_of_determinant<T>(sign, n);
      const auto space = object_space(map);
      const vec3<T> a{map[0]}, bc = cross_compensated<T>(vec3<T>{map[1]}, vec3<T>{map[2]});
      // By the inverse transpose, (1, 0, 0) becomes b × c over the determinant.
      const vec3<T> normal = normal_to_world<T>(space, {1, 0, 0});
      EXPECT_GT(T(sign) * dot(normal, bc), 0) << "sign " << sign << ", n " << n;
      EXPECT_EQ(determinant_of<T>(a, vec3<T>{map[1]}, vec3<T>{map[2]}, bc), T(sign)) << "n " << n;
    }
  }
}

TEST(Transform, ASingularMatrixGivesAMiss) {
  const auto space = object_space(glm::dmat4(0));
  const Ray<double> world{{0, 0, -5}, {0, 0, 1}};
  const Ray<double> object = to_object(space, world);
  EXPECT_EQ(nearest(object, sphere::Centred::roots(object, Sphere<double>{{0, 0, 0}, 1})), infinity<double>);
}

}  // namespace
}  // namespace rayproof
