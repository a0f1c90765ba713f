/// \file
/// Cases of the polygon oracle whose answers are proved by hand.

#include <cfloat>

#include "unit/oracle/cases.hpp"

namespace rayproof::oracle::test {
namespace {

/// A square of side 4 with a notch that reaches down to its middle: concave at (2, 2).
const Polygon<double> notched{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 2, 0}, {0, 4, 0}}};

/// A pentagram: the ring of its points goes round the middle twice.
const Polygon<double> pentagram{{{0, 10, 0}, {6, -8, 0}, {-10, 3, 0}, {10, 3, 0}, {-6, -8, 0}}};

TEST(PolygonOracle, HoldsInsideSidesAndVertices) {
  const RayAnswer found = met(down(1, 1), notched);
  expect_hits(found, Contact::crossing, {2});
  EXPECT_EQ(*found.normal, glm::dvec3(0, 0, 1));
  EXPECT_FALSE(found.barycentric.has_value());
  for (const auto& [x, y] : {std::pair{2, 0}, {4, 1}, {3, 3}, {1, 3}, {0, 2}})
    expect_hits(met(down(x, y), notched), Contact::edge, {2});
  for (const auto& [x, y] : {std::pair{0, 0}, {4, 0}, {4, 4}, {2, 2}, {0, 4}})
    expect_hits(met(down(x, y), notched), Contact::vertex, {2});
}

TEST(PolygonOracle, MissesInTheNotchAndByTheSmallestStep) {
  expect_miss(met(down(2, 3), notched), Contact::none);
  expect_miss(met(down(2, std::nextafter(2.0, 3.0)), notched), Contact::none);
  expect_hits(met(down(2, std::nextafter(2.0, 1.0)), notched), Contact::crossing, {2});
  expect_miss(met(down(2, -DBL_TRUE_MIN), notched), Contact::none);
  expect_miss(met(down(-1, 2), notched), Contact::none);  // level with the notch's vertex
  expect_miss(met(down(-1, 4), notched), Contact::none);  // level with two peaks
}

TEST(PolygonOracle, CountsSidesByTheEvenOddRule) {
  expect_miss(met(down(0, 0), pentagram), Contact::none);
  expect_hits(met(down(0, 8), pentagram), Contact::crossing, {2});
  expect_hits(met(down(0, 3), pentagram), Contact::edge, {2});
}

TEST(PolygonOracle, TakesABowTieOfOneSurplusForItsLargerHalf) {
  // The halves turn opposite ways, of areas 1 and 4: the Newell normal is that of the larger.
  const Polygon<double> tie{{{-1, -1, 0}, {2, 2, 0}, {2, -2, 0}, {-1, 1, 0}}};
  const RayAnswer large = met(down(1, 0), tie);
  expect_hits(large, Contact::crossing, {2});
  EXPECT_EQ(*large.normal, glm::dvec3(0, 0, -1));
  EXPECT_EQ(*met(down(-0.5, 0), tie).normal, glm::dvec3(0, 0, -1));
  expect_hits(met(down(0, 0), tie), Contact::edge, {2});  // where the sides cross no vertex is
}

TEST(PolygonOracle, TakesNoNetAreaForDegenerate) {
  const Polygon<double> balanced{{{-1, -1, 0}, {1, 1, 0}, {1, -1, 0}, {-1, 1, 0}}};
  expect_miss(met(down(0.5, 0), balanced), Contact::degenerate);
  expect_miss(met(down(0, 0), Polygon<double>{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}}),
              Contact::degenerate);
}

TEST(PolygonOracle, DistinguishesAParallelLineFromOneInThePlane) {
  expect_miss(met({{-9, 1, 0}, {1, 0, 0}}, notched), Contact::in_surface);
  expect_miss(met({{-9, 99, 0}, {1, 0, 0}}, notched), Contact::in_surface);
  expect_miss(met({{-9, 1, DBL_TRUE_MIN}, {1, 0, 0}}, notched), Contact::parallel);
}

TEST(PolygonOracle, LetsRepeatedVerticesAndStraightCornersChangeNothing) {
  const Polygon<double> padded{
      {{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 2, 0}, {2, 2, 0}, {0, 4, 0}}};
  expect_hits(met(down(1, 1), padded), Contact::crossing, {2});
  expect_hits(met(down(2, 0), padded), Contact::vertex, {2});
  expect_hits(met(down(2, 2), padded), Contact::vertex, {2});
  expect_miss(met(down(2, 3), padded), Contact::none);
}

// A skew quadrilateral's plane goes through its first vertex; the other three may lie off it.
TEST(PolygonOracle, PutsThePlaneThroughTheFirstVertex) {
  const Polygon<double> skew{{{0, 0, 1}, {4, 0, 0}, {4, 4, 1}, {0, 4, 0}}};  // Newell normal (0, 0, 32)
  expect_hits(met(down(2, 2), skew), Contact::crossing, {1});
  expect_hits(met(down(4, 0), skew), Contact::vertex, {1});
}

// The normal (0, 1, 1) ties y with z. The skew square's place is judged in x and y, since the later axis
// goes.
TEST(PolygonOracle, DropsTheLaterAxisOfATie) {
  const Polygon<double> tied{{{0, 0, 0}, {4, 0, 0}, {4, 4, -4}, {0, 4, -4}}};
  expect_hits(met({{1, 3, 9}, {0, 0, -1}}, tied), Contact::crossing, {12});
  // Nodding two vertices along (0, 1, -1) and back along it would not move the plane, but off it this does:
  const Polygon<double> bent{{{0, 0, 0}, {4, 0, 2}, {4, 4, -4}, {0, 4, -2}}};
  const RayAnswer found = met({{1, 4, 9}, {0, 0, -1}}, bent);
  EXPECT_EQ(found.contact, Contact::edge);  // on the side y = 4 of the projection along z
}

/// The margin of a case whose verdict is claimed to be the other one.
double margin_of_the_other_verdict(const Ray<double>& ray, const Polygon<double>& polygon) {
  const Case one{.question = RayQuestion{ray, polygon}};
  RayAnswer claimed{Contact::none};
  if (ray_answer(one).hits.count == 0) claimed.hits.push_back(1);
  return judge(one, claimed).margin;
}

TEST(PolygonOracle, ExcusesATieOfTheNormalsComponentsOnlyWhereTheOtherAxisSeesAnotherVerdict) {
  const Polygon<double> flat{{{0, 0, 0}, {4, 4, 0}, {4, 4, 4}, {0, 0, 4}}};  // of normal (-16, 16, 0)
  EXPECT_GT(margin_of_the_other_verdict({{3, 1, 2}, {-1, 1, 0}}, flat), 1e12);
  // Of normal (2, -2, 0), and far from a plane: seen along y the ray at (3, 2, 2) is inside, seen along x
  // outside.
  const Polygon<double> bent{{{4, 3, 4}, {0, 2, 3}, {4, 3, 2}, {1, 3, 0}}};
  EXPECT_EQ(margin_of_the_other_verdict({{0, 2, 2}, {1, 0, 0}}, bent), 0);
}

TEST(PolygonOracle, IncludesBothEndsOfTheInterval) {
  Ray<double> ray = down(1, 1);
  ray.t_min = ray.t_max = 2;
  expect_hits(met(ray, notched), Contact::crossing, {2});
  ray.t_max = ray.t_min = std::nextafter(2.0, 3.0);
  expect_miss(met(ray, notched), Contact::none);
}

TEST(PolygonOracle, RoundsTiesToEven) {
  const auto t = [](double height) {
    return met({{1, 1, height}, {0, 0, -0x1p+24}}, notched, Precision::float32).hits.t[0];
  };
  EXPECT_EQ(t(0x1p+24 + 1), 1);
  EXPECT_EQ(t(0x1p+24 + 3), 1 + 0x1p-22);
}

TEST(PolygonOracle, BearsSubnormalsAndTheLargestNumbers) {
  for (const double size : {DBL_TRUE_MIN, 0x1p-1000, 0x1p+1000}) {
    Polygon<double> scaled = notched;
    for (glm::dvec3& vertex : scaled.vertices) vertex *= size;
    const Ray<double> ray{{size, size, 2 * size}, {0, 0, -size}};
    expect_hits(met(ray, scaled), Contact::crossing, {2});
    expect_miss(met({{2 * size, 3 * size, 2 * size}, {0, 0, -size}}, scaled), Contact::none);
    expect_hits(met({{3 * size, 3 * size, 2 * size}, {0, 0, -size}}, scaled), Contact::edge, {2});
  }
}

TEST(PolygonOracle, TurnsAndMirrorsTheNormalWithThePolygon) {
  EXPECT_EQ(*met_under(stretch(-1, 1, 1), down(-1, 1), notched).normal, glm::dvec3(0, 0, 1));
  EXPECT_EQ(*met_under(stretch(1, 1, -1), down(1, 1), notched).normal, glm::dvec3(0, 0, -1));
}

}  // namespace
}  // namespace rayproof::oracle::test
