/// \file
/// Cases of the triangle oracle whose answers are proved by hand.

#include <cfloat>

#include "unit/oracle/cases.hpp"

namespace rayproof::oracle::test {
namespace {

const Triangle<double> right_angled{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

TEST(TriangleOracle, MeetsTheInsideWithItsBarycentricCoordinates) {
  const RayAnswer found = met(down(1, 2), right_angled);
  expect_hits(found, Contact::crossing, {2});
  EXPECT_EQ(*found.point, glm::dvec3(1, 2, 0));
  EXPECT_EQ(*found.normal, glm::dvec3(0, 0, 1));
  EXPECT_EQ(*found.barycentric, glm::dvec3(0.25, 0.25, 0.5));
}

TEST(TriangleOracle, NamesEdgesAndVertices) {
  for (const auto& [x, y] : {std::pair{1, 0}, {0, 3}, {1, 3}})
    expect_hits(met(down(x, y), right_angled), Contact::edge, {2});
  for (const auto& [x, y] : {std::pair{0, 0}, {4, 0}, {0, 4}})
    expect_hits(met(down(x, y), right_angled), Contact::vertex, {2});
  EXPECT_EQ(*met(down(4, 0), right_angled).barycentric, glm::dvec3(0, 1, 0));
  EXPECT_EQ(*met(down(1, 3), right_angled).barycentric, glm::dvec3(0, 0.25, 0.75));
}

TEST(TriangleOracle, MissesByTheSmallestStepOffAnEdge) {
  expect_miss(met(down(1, -DBL_TRUE_MIN), right_angled), Contact::none);
  expect_hits(met(down(1, DBL_TRUE_MIN), right_angled), Contact::crossing, {2});
  expect_miss(met(down(std::nextafter(1.0, 2.0), 3), right_angled), Contact::none);
  expect_hits(met(down(std::nextafter(1.0, 0.0), 3), right_angled), Contact::crossing, {2});
  expect_miss(met(down(std::nextafter(4.0, 5.0), 0), right_angled), Contact::none);
}

TEST(TriangleOracle, MissesOnTheLineOfAnEdgeBeyondItsEnds) {
  expect_miss(met(down(5, 0), right_angled), Contact::none);
  expect_miss(met(down(-1, 0), right_angled), Contact::none);
  expect_miss(met(down(-1, 5), right_angled), Contact::none);
}

TEST(TriangleOracle, TurnsTheNormalWithTheOrderOfTheVertices) {
  const Triangle<double> turned{right_angled.a, right_angled.c, right_angled.b};
  const RayAnswer found = met(down(1, 2), turned);
  expect_hits(found, Contact::crossing, {2});
  EXPECT_EQ(*found.normal, glm::dvec3(0, 0, -1));
  EXPECT_EQ(*found.barycentric, glm::dvec3(0.25, 0.5, 0.25));
}

TEST(TriangleOracle, DistinguishesAParallelLineFromOneInThePlane) {
  expect_miss(met({{-1, 1, 0}, {1, 0, 0}}, right_angled), Contact::in_surface);
  expect_miss(met({{-9, 50, 0}, {1, 0, 0}}, right_angled), Contact::in_surface);  // the line passes it by
  expect_miss(met({{-1, 0, 0}, {1, 0, 0}}, right_angled), Contact::in_surface);   // along an edge
  expect_miss(met({{-1, 1, DBL_TRUE_MIN}, {1, 0, 0}}, right_angled), Contact::parallel);
}

TEST(TriangleOracle, TakesNoAreaForDegenerate) {
  const Triangle<double> point{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  const Triangle<double> line{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}};
  const Triangle<double> almost{{0, 0, 0}, {1, 2, 3}, {2, 4, std::nextafter(6.0, 7.0)}};
  expect_miss(met({{1, 1, 0}, {0, 0, 1}}, point), Contact::degenerate);
  expect_miss(met({{1, 2, 0}, {0, 0, 1}}, line), Contact::degenerate);
  expect_hits(met({{0, 2, 3}, {1, 0, 0}}, almost), Contact::vertex, {1});
}

TEST(TriangleOracle, IncludesBothEndsOfTheInterval) {
  Ray<double> ray = down(1, 2);
  ray.t_min = ray.t_max = 2;
  expect_hits(met(ray, right_angled), Contact::crossing, {2});
  ray.t_min = ray.t_max = std::nextafter(2.0, 3.0);
  expect_miss(met(ray, right_angled), Contact::none);
  ray.t_min = ray.t_max = std::nextafter(2.0, 1.0);
  expect_miss(met(ray, right_angled), Contact::none);
}

TEST(TriangleOracle, CountsAnOriginOnTheSurface) {
  expect_hits(met({{1, 0, 0}, {3, 1, 1}}, right_angled), Contact::edge, {0});
  expect_miss(met({{1, 0, DBL_TRUE_MIN}, {3, 1, 1}}, right_angled), Contact::none);
}

TEST(TriangleOracle, RoundsEveryNumberOnce) {
  // The centre of gravity is at (4/3, 4/3): three exact thirds, and t = 2/3.
  const RayAnswer found = met({{0, 0, 2}, {2, 2, -3}}, right_angled);
  expect_hits(found, Contact::crossing, {2.0 / 3});
  EXPECT_EQ(*found.barycentric, glm::dvec3(1.0 / 3));
  EXPECT_EQ(*found.point, glm::dvec3(4.0 / 3, 4.0 / 3, 0));
  const RayAnswer narrow = met({{0, 0, 2}, {2, 2, -3}}, right_angled, Precision::float32);
  EXPECT_EQ(narrow.hits.t[0], double{2.0F / 3});
  EXPECT_EQ(*narrow.barycentric, glm::dvec3(1.0F / 3));
}

TEST(TriangleOracle, RoundsTiesToEven) {
  const auto t = [](double height) {
    return met({{1, 1, height}, {0, 0, -0x1p+24}}, right_angled, Precision::float32).hits.t[0];
  };
  EXPECT_EQ(t(0x1p+24 + 1), 1);
  EXPECT_EQ(t(0x1p+24 + 3), 1 + 0x1p-22);
}

TEST(TriangleOracle, BearsSubnormalsAndTheLargestNumbers) {
  for (const double size : {DBL_TRUE_MIN, 0x1p-1000, 0x1p+1000}) {
    const Triangle<double> scaled{{0, 0, 0}, {4 * size, 0, 0}, {0, 4 * size, 0}};
    const RayAnswer found = met({{size, 2 * size, 2 * size}, {0, 0, -size}}, scaled);
    expect_hits(found, Contact::crossing, {2});
    EXPECT_EQ(*found.barycentric, glm::dvec3(0.25, 0.25, 0.5));
    EXPECT_EQ(*found.normal, glm::dvec3(0, 0, 1));
    expect_hits(met({{size, 3 * size, 2 * size}, {0, 0, -size}}, scaled), Contact::edge, {2});
  }
}

TEST(TriangleOracle, TurnsAndMirrorsTheNormalWithTheTriangle) {
  const RayAnswer mirrored = met_under(stretch(-1, 1, 1), down(-1, 2), right_angled);
  expect_hits(mirrored, Contact::crossing, {2});
  EXPECT_EQ(*mirrored.normal, glm::dvec3(0, 0, 1));
  EXPECT_EQ(*mirrored.barycentric, glm::dvec3(0.25, 0.25, 0.5));
  EXPECT_EQ(*met_under(stretch(1, 1, -1), down(1, 2), right_angled).normal, glm::dvec3(0, 0, -1));
}

/// Both numbers of the side are far away, and the ray passes it at a small share of the distance between
/// them.
TEST(TriangleOracle, MeasuresHowFarARayPassesFromASideThatItRunsAlong) {
  const glm::dvec3 along{3, 5, 7}, aside{5, -3, 0}, off{21, 35, -34};  // at right angles to one another
  const double gap = 0x1p-10;
  const glm::dvec3 a = 0x1p+30 * along - 8.0 * aside + gap * off;
  const glm::dvec3 c = 0x1p+40 * along + 8.0 * aside + gap * off;
  const RayQuestion question{.ray = {{0, 0, 0}, along}, .shape = Triangle<double>{a, a + 1000.0 * off, c}};
  RayAnswer one_hit;
  one_hit.hits.count = 1;
  one_hit.hits.t[0] = 0x1p+39;
  const double reach = glm::length(c) + (0x1p+29 + 0x1p+39) * glm::length(along);
  EXPECT_NEAR(judge({.question = question}, one_hit).margin * 0x1p-53, gap * glm::length(off) / reach,
              1e-6 * gap * glm::length(off) / reach);
}

}  // namespace
}  // namespace rayproof::oracle::test
