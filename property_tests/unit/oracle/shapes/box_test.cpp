/// \file
/// Cases of the box oracle whose answers are proved by hand.

#include <cfloat>

#include "unit/oracle/cases.hpp"

namespace rayproof::oracle::test {
namespace {

const Box<double> brick{{0, 0, 0}, {2, 4, 6}};

TEST(BoxOracle, MeetsTwoFacesWithTheOutwardNormalOfTheFirst) {
  const RayAnswer found = met({{1, 1, -3}, {0, 0, 1}}, brick);
  expect_hits(found, Contact::crossing, {3, 9});
  EXPECT_EQ(*found.point, glm::dvec3(1, 1, 0));
  EXPECT_EQ(*found.normal, glm::dvec3(0, 0, -1));
  EXPECT_EQ(*met({{1, 1, 9}, {0, 0, -1}}, brick).normal, glm::dvec3(0, 0, 1));
  EXPECT_EQ(*met({{-1, 1, 1}, {1, 0, 0}}, brick).normal, glm::dvec3(-1, 0, 0));
  EXPECT_EQ(*met({{1, 7, 1}, {0, -1, 0}}, brick).normal, glm::dvec3(0, 1, 0));
}

TEST(BoxOracle, LeavesFromInsideWithTheNormalOutward) {
  const RayAnswer found = met({{1, 1, 1}, {0, 2, 0}}, brick);
  expect_hits(found, Contact::crossing, {1.5});
  EXPECT_EQ(*found.normal, glm::dvec3(0, 1, 0));
}

TEST(BoxOracle, TouchesAnEdgeOrACornerOnceWithoutANormal) {
  // x + y = 0 touches the edge x = y = 0; the second one the corner (2, 4, 6).
  const RayAnswer edge = met({{-1, 1, 3}, {1, -1, 0}}, brick);
  expect_hits(edge, Contact::tangent, {1});
  EXPECT_FALSE(edge.normal.has_value());
  const RayAnswer corner = met({{1, 5, 6}, {1, -1, 0}}, brick);
  expect_hits(corner, Contact::tangent, {1});
  EXPECT_FALSE(corner.normal.has_value());
  expect_miss(met({{-1, std::nextafter(1.0, 0.0), 3}, {1, -1, 0}}, brick), Contact::none);
  EXPECT_EQ(met({{-1, std::nextafter(1.0, 2.0), 3}, {1, -1, 0}}, brick).hits.count, 2U);
}

TEST(BoxOracle, CrossesFromCornerToCornerWithoutANormal) {
  const RayAnswer found = met({{-1, -2, -3}, {1, 2, 3}}, brick);
  expect_hits(found, Contact::crossing, {1, 3});
  EXPECT_FALSE(found.normal.has_value());
}

TEST(BoxOracle, HoldsTheLinesInItsFacesAndEdges) {
  const RayAnswer face = met({{-1, 1, 0}, {1, 0, 0}}, brick);  // in the face z = 0
  expect_hits(face, Contact::crossing, {1, 3});
  EXPECT_FALSE(face.normal.has_value());  // its first point is on an edge
  expect_hits(met({{-1, 0, 6}, {1, 0, 0}}, brick), Contact::crossing, {1, 3});
  expect_miss(met({{-1, 1, -DBL_TRUE_MIN}, {1, 0, 0}}, brick), Contact::none);
  expect_miss(met({{-1, 1, std::nextafter(6.0, 7.0)}, {1, 0, 0}}, brick), Contact::none);
}

TEST(BoxOracle, MeetsAFlatBoxOnce) {
  const Box<double> flat{{0, 0, 1}, {2, 4, 1}};
  const RayAnswer through = met({{1, 1, -3}, {0, 0, 1}}, flat);
  expect_hits(through, Contact::tangent, {4});
  EXPECT_FALSE(through.normal.has_value());  // two faces in one place, and two ways outward
  expect_hits(met({{-1, 1, 1}, {1, 0, 0}}, flat), Contact::crossing, {1, 3});
  expect_miss(met({{-1, 1, std::nextafter(1.0, 2.0)}, {1, 0, 0}}, flat), Contact::none);
}

TEST(BoxOracle, TakesABoxOfOneEdgeOrOnePointForThat) {
  const Box<double> rod{{1, 1, 0}, {1, 1, 6}};
  expect_hits(met({{0, 0, 3}, {1, 1, 0}}, rod), Contact::tangent, {1});
  expect_hits(met({{1, 1, -1}, {0, 0, 1}}, rod), Contact::crossing, {1, 7});
  const Box<double> point{{1, 2, 3}, {1, 2, 3}};
  expect_hits(met({{0, 0, 0}, {1, 2, 3}}, point), Contact::tangent, {1});
  expect_miss(met({{0, 0, DBL_TRUE_MIN}, {1, 2, 3}}, point), Contact::none);
}

TEST(BoxOracle, IncludesBothEndsOfTheInterval) {
  Ray<double> ray{{1, 1, -3}, {0, 0, 1}, 3, 9};
  expect_hits(met(ray, brick), Contact::crossing, {3, 9});
  ray.t_min = std::nextafter(3.0, 4.0);
  const RayAnswer second = met(ray, brick);
  expect_hits(second, Contact::crossing, {9});
  EXPECT_EQ(*second.normal, glm::dvec3(0, 0, 1));
  ray.t_max = std::nextafter(9.0, 8.0);
  expect_miss(met(ray, brick), Contact::none);  // all inside, and no end of it
}

TEST(BoxOracle, CountsAnOriginOnAFaceAndBehindIt) {
  expect_hits(met({{1, 1, 0}, {0, 0, 1}}, brick), Contact::crossing, {0, 6});
  expect_hits(met({{1, 1, 0}, {0, 0, -1}}, brick), Contact::crossing, {0});
  expect_miss(met({{1, 1, -DBL_TRUE_MIN}, {0, 0, -1}}, brick), Contact::none);
}

TEST(BoxOracle, TakesANegativeZeroForZero) {
  expect_hits(met({{0, 1, -1}, {-0.0, 0, 1}}, brick), Contact::crossing, {1, 7});
  expect_hits(met({{-0.0, 1, -1}, {0, -0.0, 1}}, brick), Contact::crossing, {1, 7});
}

TEST(BoxOracle, ListsTwoHitsThatRoundToOneNumber) {
  const Box<double> thin{{0, 0, 0}, {1, 1, 0x1p-80}};
  expect_hits(met({{0.5, 0.5, -1}, {0, 0, 1}}, thin), Contact::crossing, {1, 1});
}

TEST(BoxOracle, RoundsTiesToEven) {
  const Box<double> far{{-1, -1, 0x1p+24 + 1}, {1, 1, 0x1p+24 + 3}};
  EXPECT_TRUE(hits_at(met({{0, 0, 0}, {0, 0, 0x1p+24}}, far, Precision::float32), {1, 1 + 0x1p-22}));
}

TEST(BoxOracle, BearsSubnormalsAndTheLargestNumbers) {
  const double tiny = DBL_TRUE_MIN;
  expect_hits(met({{tiny, tiny, -tiny}, {0, 0, tiny}}, Box<double>{{0, 0, 0}, {tiny, tiny, tiny}}),
              Contact::crossing, {1, 2});
  expect_hits(met({{0, 0, 0}, {0, 0, tiny}}, brick), Contact::crossing, {0, infinity<double>});
  const Box<double> all{glm::dvec3(-DBL_MAX), glm::dvec3(DBL_MAX)};
  expect_hits(met({{-DBL_MAX, 0, 0}, {DBL_MAX, 0, 0}}, all), Contact::crossing, {0, 2});
  expect_hits(met({{-DBL_MAX, 0, 0}, {1, 0, 0}}, all), Contact::crossing, {0, infinity<double>});
  expect_hits(met({{-0x1p+1000, 0, 0}, {0x1p+1000, tiny, 0}}, brick), Contact::crossing, {1, 1});
}

TEST(BoxOracle, PointsTheNormalOutwardUnderAMirror) {
  const RayAnswer found = met_under(stretch(1, 1, -1), {{1, 1, 3}, {0, 0, -1}}, brick);
  expect_hits(found, Contact::crossing, {3, 9});
  EXPECT_EQ(*found.normal, glm::dvec3(0, 0, 1));
}

TEST(BoxOracle, BendsTheNormalOfAShearedBox) {
  glm::dmat4 shear(1);
  shear[2][0] = 1;  // (x + z, y, z): the face x = 0 becomes x = z
  const RayAnswer found = met_under(shear, {{-5, 1, 1}, {1, 0, 0}}, brick);
  expect_hits(found, Contact::crossing, {6, 8});
  EXPECT_NEAR(found.normal->x, -std::sqrt(0.5), 0x1p-52);
  EXPECT_NEAR(found.normal->z, std::sqrt(0.5), 0x1p-52);
}

}  // namespace
}  // namespace rayproof::oracle::test
