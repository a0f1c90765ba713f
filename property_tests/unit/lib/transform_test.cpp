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

TEST(Transform, ASingularMatrixGivesAMiss) {
  const auto space = object_space(glm::dmat4(0));
  const Ray<double> world{{0, 0, -5}, {0, 0, 1}};
  const Ray<double> object = to_object(space, world);
  EXPECT_EQ(nearest(object, sphere::Centred::roots(object, Sphere<double>{{0, 0, 0}, 1})), infinity<double>);
}

}  // namespace
}  // namespace rayproof
