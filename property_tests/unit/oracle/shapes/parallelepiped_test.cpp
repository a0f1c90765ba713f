/// \file
/// Cases of the parallelepiped oracle whose answers are proved by hand.

#include <cfloat>

#include "unit/oracle/cases.hpp"

namespace rayproof::oracle::test {
namespace {

/// The unit cube leaning one to the right over its height of 1: x - z, y and z in [0, 1].
const Parallelepiped<double> leaning{{0, 0, 0}, {glm::dvec3{1, 0, 0}, {0, 1, 0}, {1, 0, 1}}};

TEST(ParallelepipedOracle, MeetsLeaningFacesWithTheirOutwardNormals) {
  const RayAnswer found = met({{-5, 0.5, 0.25}, {1, 0, 0}}, leaning);
  expect_hits(found, Contact::crossing, {5.25, 6.25});
  EXPECT_NEAR(found.normal->x, -std::sqrt(0.5), 0x1p-52);
  EXPECT_EQ(found.normal->y, 0);
  EXPECT_NEAR(found.normal->z, std::sqrt(0.5), 0x1p-52);
  const RayAnswer above = met({{1.5, 0.5, 3}, {0, 0, -1}}, leaning);
  expect_hits(above, Contact::crossing, {2, 2.5});
  EXPECT_EQ(*above.normal, glm::dvec3(0, 0, 1));
}

TEST(ParallelepipedOracle, PointsNormalsOutwardWhateverTheOrderOfTheEdges) {
  Parallelepiped<double> turned = leaning;
  std::swap(turned.edges[0], turned.edges[1]);
  EXPECT_EQ(*met({{1.5, 0.5, 3}, {0, 0, -1}}, turned).normal, glm::dvec3(0, 0, 1));
  // The same solid from the opposite corner, with the edges run backwards.
  const Parallelepiped<double> opposite{{2, 1, 1}, {glm::dvec3{-1, 0, 0}, {0, -1, 0}, {-1, 0, -1}}};
  const RayAnswer found = met({{1.5, 0.5, 3}, {0, 0, -1}}, opposite);
  expect_hits(found, Contact::crossing, {2, 2.5});
  EXPECT_EQ(*found.normal, glm::dvec3(0, 0, 1));
}

TEST(ParallelepipedOracle, TouchesAnEdgeOrACornerOnceWithoutANormal) {
  // At x = 2 the leaning cube has nothing but the upper right edge, y from 0 to 1.
  const RayAnswer edge = met({{2, 0.5, -1}, {0, 0, 1}}, leaning);
  expect_hits(edge, Contact::tangent, {2});
  EXPECT_FALSE(edge.normal.has_value());
  expect_hits(met({{2, 1, -1}, {0, 0, 1}}, leaning), Contact::tangent, {2});
  expect_miss(met({{2, std::nextafter(1.0, 2.0), -1}, {0, 0, 1}}, leaning), Contact::none);
  expect_miss(met({{std::nextafter(2.0, 3.0), 0.5, -1}, {0, 0, 1}}, leaning), Contact::none);
  EXPECT_EQ(met({{std::nextafter(2.0, 1.0), 0.5, -1}, {0, 0, 1}}, leaning).hits.count, 2U);
}

TEST(ParallelepipedOracle, HoldsTheLinesInItsFacesAndEdges) {
  const RayAnswer face = met({{-1, 0.5, -1}, {1, 0, 1}}, leaning);  // in the face x = z
  expect_hits(face, Contact::crossing, {1, 2});
  EXPECT_FALSE(face.normal.has_value());
  expect_hits(met({{-1, 0, -1}, {1, 0, 1}}, leaning), Contact::crossing, {1, 2});  // along an edge
  expect_miss(met({{-1 - 0x1p-52, 0.5, -1}, {1, 0, 1}}, leaning), Contact::none);
  expect_hits(met({{-1, 0, 0.5}, {1, 0, 0}}, leaning), Contact::crossing, {1.5, 2.5});  // in the face y = 0
}

TEST(ParallelepipedOracle, IncludesBothEndsOfTheInterval) {
  Ray<double> ray{{-5, 0.5, 0.25}, {1, 0, 0}, 5.25, 6.25};
  expect_hits(met(ray, leaning), Contact::crossing, {5.25, 6.25});
  ray.t_min = std::nextafter(5.25, 6.0);
  const RayAnswer second = met(ray, leaning);
  expect_hits(second, Contact::crossing, {6.25});
  EXPECT_NEAR(second.normal->x, std::sqrt(0.5), 0x1p-52);
  ray.t_max = std::nextafter(6.25, 6.0);
  expect_miss(met(ray, leaning), Contact::none);
}

TEST(ParallelepipedOracle, AgreesWithTheBoxThatItIs) {
  const Parallelepiped<double> upright{{0, 0, 0}, {glm::dvec3{2, 0, 0}, {0, 4, 0}, {0, 0, 6}}};
  const RayAnswer found = met({{1, 1, -3}, {0, 0, 1}}, upright);
  expect_hits(found, Contact::crossing, {3, 9});
  EXPECT_EQ(*found.normal, glm::dvec3(0, 0, -1));
}

TEST(ParallelepipedOracle, BearsSolidsAlmostFlat) {
  // Over the unit square, 2^-80 thick, and leaning by a whole unit.
  const Parallelepiped<double> sheet{{0, 0, 0}, {glm::dvec3{1, 0, 0}, {0, 1, 0}, {1, 0, 0x1p-80}}};
  expect_hits(met({{0.5, 0.5, -1}, {0, 0, 1}}, sheet), Contact::crossing, {1, 1});
  expect_hits(met({{2, 0.5, -1}, {0, 0, 1}}, sheet), Contact::tangent, {1});
  expect_hits(met({{0.5, 0.5, 0}, {0, 0, 0x1p-80}}, sheet), Contact::crossing, {0, 0.5});
}

TEST(ParallelepipedOracle, RoundsTiesToEven) {
  const Parallelepiped<double> far{{-1, -1, 0x1p+24 + 1}, {glm::dvec3{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}};
  EXPECT_TRUE(hits_at(met({{0, 0, 0}, {0, 0, 0x1p+24}}, far, Precision::float32), {1, 1 + 0x1p-22}));
}

TEST(ParallelepipedOracle, BearsSubnormalsAndTheLargestNumbers) {
  for (const double size : {DBL_TRUE_MIN, 0x1p-1000, 0x1p+1000}) {
    const Parallelepiped<double> scaled{
        {0, 0, 0}, {glm::dvec3{4 * size, 0, 0}, {0, 4 * size, 0}, {4 * size, 0, 4 * size}}};
    const RayAnswer found = met({{6 * size, 2 * size, 9 * size}, {0, 0, -size}}, scaled);
    expect_hits(found, Contact::crossing, {5, 7});
    EXPECT_EQ(*found.normal, glm::dvec3(0, 0, 1));
    expect_hits(met({{8 * size, 2 * size, 9 * size}, {0, 0, -size}}, scaled), Contact::tangent, {5});
  }
}

TEST(ParallelepipedOracle, PointsTheNormalOutwardUnderAMirror) {
  const RayAnswer found = met_under(stretch(1, 1, -1), {{1.5, 0.5, -3}, {0, 0, 1}}, leaning);
  expect_hits(found, Contact::crossing, {2, 2.5});
  EXPECT_EQ(*found.normal, glm::dvec3(0, 0, -1));
}

}  // namespace
}  // namespace rayproof::oracle::test
