/// \file
/// Cases of the sphere oracle whose answers are proved by hand.

#include <gtest/gtest.h>

#include <cfloat>

#include "unit/oracle/cases.hpp"

namespace rayproof::oracle::test {
namespace {

TEST(SphereOracle, MeetsTheUnitSphereAtFourAndSix) {
  const RayAnswer found = ray_answer(sphere_case({0, 0, -5}, {0, 0, 1}, {0, 0, 0}, 1));
  ASSERT_EQ(found.hits.count, 2U);
  EXPECT_EQ(found.hits.t[0], 4);
  EXPECT_EQ(found.hits.t[1], 6);
  EXPECT_EQ(found.contact, Contact::crossing);
  EXPECT_EQ(*found.point, glm::dvec3(0, 0, -1));
  EXPECT_EQ(*found.normal, glm::dvec3(0, 0, -1));
}

TEST(SphereOracle, CountsATangentOnce) {
  const RayAnswer found = ray_answer(sphere_case({0, 1, -5}, {0, 0, 1}, {0, 0, 0}, 1));
  ASSERT_EQ(found.hits.count, 1U);
  EXPECT_EQ(found.hits.t[0], 5);
  EXPECT_EQ(found.contact, Contact::tangent);
}

TEST(SphereOracle, MissesByOneUlp) {
  EXPECT_EQ(ray_answer(sphere_case({0, std::nextafter(1.0, 2.0), -5}, {0, 0, 1}, {0, 0, 0}, 1)).hits.count,
            0U);
  EXPECT_EQ(ray_answer(sphere_case({0, std::nextafter(1.0, 0.0), -5}, {0, 0, 1}, {0, 0, 0}, 1)).hits.count,
            2U);
}

TEST(SphereOracle, JudgesAnInfiniteHitOfARayThatMissesAsWrongWithoutAskingForItsRoot) {
  const Case one = sphere_case({0, 0.001, -1}, {0, 0, 1e-25}, {0, 0, 0}, 0.0001);
  for (const double t : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    RayAnswer claimed;
    claimed.hits.t[claimed.hits.count++] = t;
    const Judgement judgement = judge(one, claimed);
    EXPECT_TRUE(judgement.wrong);
    EXPECT_FALSE(judgement.hit);
    EXPECT_EQ(judgement.residual, HUGE_VAL);
    EXPECT_TRUE(std::isnan(judgement.ulp));
  }
}

TEST(SphereOracle, CountsAnOriginOnTheSurface) {
  const RayAnswer found = ray_answer(sphere_case({0, 0, -1}, {0, 0, 3}, {0, 0, 0}, 1));
  ASSERT_EQ(found.hits.count, 2U);
  EXPECT_EQ(found.hits.t[0], 0);
  EXPECT_EQ(found.hits.t[1], 2.0 / 3);
}

TEST(SphereOracle, IncludesBothEndsOfTheInterval) {
  Case one = sphere_case({0, 0, -5}, {0, 0, 1}, {0, 0, 0}, 1);
  question_of(one).ray.t_min = 4;
  question_of(one).ray.t_max = 6;
  EXPECT_EQ(ray_answer(one).hits.count, 2U);
  question_of(one).ray.t_min = std::nextafter(4.0, 5.0);
  question_of(one).ray.t_max = std::nextafter(6.0, 5.0);
  EXPECT_EQ(ray_answer(one).hits.count, 0U);
}

TEST(SphereOracle, TakesARadiusOfZeroForAPoint) {
  const RayAnswer found = ray_answer(sphere_case({0, 0, -5}, {0, 0, 1}, {0, 0, 0}, 0));
  ASSERT_EQ(found.hits.count, 1U);
  EXPECT_EQ(found.hits.t[0], 5);
  EXPECT_EQ(found.contact, Contact::tangent);
  EXPECT_FALSE(found.normal.has_value());
  EXPECT_EQ(ray_answer(sphere_case({0, DBL_TRUE_MIN, -5}, {0, 0, 1}, {0, 0, 0}, 0)).hits.count, 0U);
}

TEST(SphereOracle, ListsTwoHitsThatRoundToOneNumber) {
  const RayAnswer found = ray_answer(sphere_case({0, 0, -1}, {0, 0, 1}, {0, 0, 0}, 0x1p-80));
  ASSERT_EQ(found.hits.count, 2U);
  EXPECT_EQ(found.hits.t[0], 1);
  EXPECT_EQ(found.hits.t[1], 1);
}

TEST(SphereOracle, BearsSubnormalsAndTheLargestNumbers) {
  const RayAnswer tiny = ray_answer(sphere_case({0, 0, 0}, {0, 0, DBL_TRUE_MIN}, {0, 0, 0}, DBL_TRUE_MIN));
  ASSERT_EQ(tiny.hits.count, 1U);
  EXPECT_EQ(tiny.hits.t[0], 1);
  const RayAnswer huge = ray_answer(sphere_case({0, 0, -DBL_MAX}, {0, 0, 1}, {0, 0, DBL_MAX}, DBL_MAX));
  ASSERT_EQ(huge.hits.count, 2U);
  EXPECT_EQ(huge.hits.t[0], DBL_MAX);
  EXPECT_TRUE(std::isinf(huge.hits.t[1]));
  const RayAnswer overflowing = ray_answer(sphere_case({0, 0, 0}, {0, 0, DBL_TRUE_MIN}, {0, 0, 0}, DBL_MAX));
  ASSERT_EQ(overflowing.hits.count, 1U);
  EXPECT_TRUE(std::isinf(overflowing.hits.t[0]));
}

TEST(SphereOracle, MeasuresAHitFarFromASmallRootInTheRootsOwnUlps) {
  const Case one = sphere_case({0, 0, -0x1p210 - 0x1p160}, {0, 0, 1}, {0, 0, 0}, 0x1p210);  // met at 2^160
  RayAnswer claimed{.nearest_only = true};
  claimed.hits.push_back(0x1p220);
  EXPECT_EQ(judge(one, claimed).ulp, 0x1p112);
}

TEST(SphereOracle, RoundsToTheCasesPrecision) {
  Case one = sphere_case({0, 0, 0}, {0, 0, 3}, {0, 0, 0}, 1);
  EXPECT_EQ(ray_answer(one).hits.t[0], 1.0 / 3);
  one.precision = Precision::float32;
  EXPECT_EQ(ray_answer(one).hits.t[0], static_cast<double>(1.0F / 3));
}

TEST(SphereOracle, KeepsTUnderATransformAndBendsTheNormal) {
  Case one = sphere_case({0, 0, -5}, {0, 0, 1}, {0, 0, 0}, 1);
  question_of(one).transform = glm::dmat4(1);
  (*question_of(one).transform)[2][2] = 2;  // twice as long along z
  EXPECT_EQ(ray_answer(one).hits.t[0], 3);
  question_of(one).ray.origin = {0.6, 0, -5};
  const RayAnswer bent = ray_answer(one);
  EXPECT_NEAR(bent.hits.t[0], 3.4, 1e-15);
  // The point (0.6, 0, -1.6) of the ellipsoid has the gradient (0.6, 0, -0.4).
  EXPECT_NEAR(bent.normal->x, 0.6 / std::hypot(0.6, 0.4), 1e-15);
  EXPECT_NEAR(bent.normal->z, -0.4 / std::hypot(0.6, 0.4), 1e-15);
}

TEST(SphereOracle, PointsTheNormalOutwardUnderAMirror) {
  Case one = sphere_case({0, 0, -5}, {0, 0, 1}, {0, 0, 0}, 1);
  question_of(one).transform = glm::dmat4(1);
  (*question_of(one).transform)[2][2] = -1;
  EXPECT_EQ(*ray_answer(one).normal, glm::dvec3(0, 0, -1));
}

}  // namespace
}  // namespace rayproof::oracle::test
