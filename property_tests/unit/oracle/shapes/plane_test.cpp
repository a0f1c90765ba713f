/// \file
/// Cases of the plane oracle, in all three forms, whose answers are proved by hand.

#include <cfloat>

#include "unit/oracle/cases.hpp"

namespace rayproof::oracle::test {
namespace {

/// The plane z = height in each of its forms, the normal upward.
std::vector<Shape> level(double height) {
  return {ImplicitPlane{{0, 0, 1}, -height}, PointNormalPlane{{7, -3, height}, {0, 0, 1}},
          ParametricPlane{{-2, 5, height}, {1, 0, 0}, {0, 1, 0}}};
}

TEST(PlaneOracle, MeetsALevelPlaneInEveryForm) {
  for (const Shape& plane : level(3)) {
    const RayAnswer found = met({{1, 2, 7}, {1, -1, -2}}, plane);
    expect_hits(found, Contact::crossing, {2});
    EXPECT_EQ(*found.point, glm::dvec3(3, 0, 3));
    EXPECT_EQ(*found.normal, glm::dvec3(0, 0, 1));  // along the given normal, whichever side the ray is on
  }
}

TEST(PlaneOracle, TurnsTheParametricNormalWithTheOrderOfUAndV) {
  const ParametricPlane turned{{0, 0, 3}, {0, 2, 0}, {5, 0, 0}};
  EXPECT_EQ(*met({{0, 0, 0}, {0, 0, 1}}, turned).normal, glm::dvec3(0, 0, -1));
}

TEST(PlaneOracle, MakesTheNormalAUnitVector) {
  const RayAnswer found = met({{0, 0, 0}, {3, 0, 4}}, ImplicitPlane{{3, 0, 4}, -25});
  expect_hits(found, Contact::crossing, {1});
  EXPECT_NEAR(found.normal->x, 0.6, 0x1p-52);
  EXPECT_NEAR(found.normal->z, 0.8, 0x1p-52);
}

TEST(PlaneOracle, DistinguishesAParallelLineFromOneInThePlane) {
  for (const Shape& plane : level(3)) {
    expect_miss(met({{1, 2, 3}, {4, -5, 0}}, plane), Contact::in_surface);
    expect_miss(met({{1, 2, std::nextafter(3.0, 4.0)}, {4, -5, 0}}, plane), Contact::parallel);
    expect_miss(met({{1, 2, std::nextafter(3.0, 2.0)}, {4, -5, 0}}, plane), Contact::parallel);
  }
}

TEST(PlaneOracle, SpeaksOfTheWholeLineWhereTheIntervalIsAPoint) {
  expect_miss(met({{1, 2, 3}, {1, 0, 0}, 5, 5}, level(3)[0]), Contact::in_surface);
}

// n·d is exactly -2^-104 for these two vectors; a rounded product makes it 0.
TEST(PlaneOracle, SeesADirectionThatIsAlmostParallel) {
  const double e = 0x1p-53;
  const RayAnswer found =
      met({{0, 0, -1}, {1 + 2 * e, 1, 0}}, PointNormalPlane{{0, 0, 0}, {1 - 2 * e, -1, -1}});
  expect_hits(found, Contact::crossing, {0x1p+104});  // n·(o - 0) = 1, n·d = 1 - 4e² - 1 = -2^-104
}

TEST(PlaneOracle, IncludesBothEndsOfTheInterval) {
  for (const Shape& plane : level(3)) {
    Ray<double> ray{{0, 0, 0}, {0, 0, 1}, 3, 3};
    expect_hits(met(ray, plane), Contact::crossing, {3});
    ray.t_max = DBL_MAX;
    ray.t_min = std::nextafter(3.0, 4.0);
    expect_miss(met(ray, plane), Contact::none);
    ray.t_min = 0;
    ray.t_max = std::nextafter(3.0, 2.0);
    expect_miss(met(ray, plane), Contact::none);
  }
}

TEST(PlaneOracle, ComparesTheExactTWithTheInterval) {
  // 3t = 1: the double 1/3 is less than a third, so that it may begin the interval but not end it.
  const ImplicitPlane plane{{0, 0, 3}, -1};
  expect_hits(met({{0, 0, 0}, {0, 0, 1}, 1.0 / 3, 1}, plane), Contact::crossing, {1.0 / 3});
  expect_miss(met({{0, 0, 0}, {0, 0, 1}, 0, 1.0 / 3}, plane), Contact::none);
}

TEST(PlaneOracle, MissesBehindTheRay) {
  for (const Shape& plane : level(-1)) {
    expect_miss(met({{0, 0, 0}, {0, 0, 1}}, plane), Contact::none);
    expect_hits(met({{0, 0, 0}, {0, 0, 1}, -infinity<double>}, plane), Contact::crossing, {-1});
  }
}

TEST(PlaneOracle, RoundsTiesToEven) {
  const auto t = [](double distance) {
    return met({{0, 0, 0}, {0, 0, 0x1p+24}}, ImplicitPlane{{0, 0, 1}, -distance}, Precision::float32)
        .hits.t[0];
  };
  EXPECT_EQ(t(0x1p+24 + 1), 1);              // halfway from 1 to 1 + 2^-23
  EXPECT_EQ(t(0x1p+24 + 3), 1 + 0x1p-22);    // halfway from 1 + 2^-23 to 1 + 2^-22
  EXPECT_EQ(t(0x1p+24 + 1.5), 1 + 0x1p-23);  // past halfway
}

TEST(PlaneOracle, BearsSubnormalsAndTheLargestNumbers) {
  const double tiny = DBL_TRUE_MIN;
  expect_hits(met({{0, 0, 0}, {0, 0, tiny}}, ImplicitPlane{{0, 0, tiny}, -tiny}), Contact::crossing,
              {infinity<double>});  // tiny / tiny² = 2^1074 overflows
  expect_hits(met({{0, 0, 0}, {0, 0, tiny}}, PointNormalPlane{{0, 0, 3 * tiny}, {0, 0, tiny}}),
              Contact::crossing, {3});
  expect_hits(met({{0, 0, -DBL_MAX}, {0, 0, DBL_MAX}}, PointNormalPlane{{0, 0, DBL_MAX}, {0, 0, DBL_MAX}}),
              Contact::crossing, {2});
  expect_hits(met({{0, 0, 0x1p+1000}, {0, 0, -0x1p+999}},
                  ParametricPlane{{0, 0, 0}, {0x1p+1000, 0, 0}, {0, tiny, 0}}),
              Contact::crossing, {2});
}

TEST(PlaneOracle, TurnsTheNormalByTheInverseTranspose) {
  // The plane x + z = 0, stretched to twice the length along z: x + z/2 = 0.
  const RayAnswer found = met_under(stretch(1, 1, 2), {{0, 0, -4}, {0, 0, 1}}, ImplicitPlane{{1, 0, 1}, 0});
  expect_hits(found, Contact::crossing, {4});
  EXPECT_NEAR(found.normal->x, 2 / std::sqrt(5.0), 0x1p-52);
  EXPECT_NEAR(found.normal->z, 1 / std::sqrt(5.0), 0x1p-52);
}

TEST(PlaneOracle, MirrorsTheNormalWithThePlane) {
  for (const Shape& plane : level(3)) {
    const RayAnswer found = met_under(stretch(1, 1, -1), {{0, 0, 0}, {0, 0, -1}}, plane);
    expect_hits(found, Contact::crossing, {3});
    EXPECT_EQ(*found.normal, glm::dvec3(0, 0, -1));
    // A mirror of an axis in the plane leaves the normal, the parametric one's too, where it was.
    EXPECT_EQ(*met_under(stretch(-1, 1, 1), {{0, 0, 0}, {0, 0, 1}}, plane).normal, glm::dvec3(0, 0, 1));
  }
}

}  // namespace
}  // namespace rayproof::oracle::test
