/// \file
/// Cases of the cylinder oracle whose answers are proved by hand.

#include <cfloat>

#include "unit/oracle/cases.hpp"

namespace rayproof::oracle::test {
namespace {

/// Over the ellipse x²/25 + y²/100 = 1, on which (3, 8) lies; 4 high.
const Cylinder<double> open{5, 10, 4, false};
const Cylinder<double> capped{5, 10, 4, true};

TEST(CylinderOracle, MeetsTheSideTwiceWithTheOutwardNormal) {
  for (const auto& tube : {open, capped}) {
    const RayAnswer found = met({{-7, 0, 1}, {1, 0, 0}}, tube);
    expect_hits(found, Contact::crossing, {2, 12});
    EXPECT_EQ(*found.normal, glm::dvec3(-1, 0, 0));
  }
  const RayAnswer oblique = met({{3, -9, 1}, {0, 1, 0}}, open);
  expect_hits(oblique, Contact::crossing, {1, 17});  // at (3, -8), where the gradient is (3/25, -8/100)
  EXPECT_NEAR(oblique.normal->x, 12 / std::sqrt(208.0), 0x1p-52);
  EXPECT_NEAR(oblique.normal->y, -8 / std::sqrt(208.0), 0x1p-52);
}

TEST(CylinderOracle, TouchesTheSideOnce) {
  const RayAnswer found = met({{5, -3, 1}, {0, 1, 0}}, open);
  expect_hits(found, Contact::tangent, {3});
  EXPECT_EQ(*found.normal, glm::dvec3(1, 0, 0));
  expect_hits(met({{5, -3, -2}, {0, 1, 1}}, capped), Contact::tangent, {3});
  expect_miss(met({{std::nextafter(5.0, 6.0), -3, 1}, {0, 1, 0}}, open), Contact::none);
  EXPECT_EQ(met({{std::nextafter(5.0, 4.0), -3, 1}, {0, 1, 0}}, open).hits.count, 2U);
}

TEST(CylinderOracle, HasCapsOnlyWhereCapped) {
  expect_miss(met({{1, 1, 9}, {0, 0, -1}}, open), Contact::none);
  const RayAnswer found = met({{1, 1, 9}, {0, 0, -1}}, capped);
  expect_hits(found, Contact::crossing, {5, 9});
  EXPECT_EQ(*found.normal, glm::dvec3(0, 0, 1));
  EXPECT_EQ(*met({{1, 1, -3}, {0, 0, 1}}, capped).normal, glm::dvec3(0, 0, -1));
  const Ray<double> through_cap_and_side{{0, 0, 5}, {5, 0, -2}};  // down at (2.5, 0, 4), out at (5, 0, 3)
  expect_hits(met(through_cap_and_side, capped), Contact::crossing, {0.5, 1});
  expect_hits(met(through_cap_and_side, open), Contact::crossing, {1});
}

TEST(CylinderOracle, HitsARimWithoutANormal) {
  for (const auto& tube : {open, capped}) {
    const RayAnswer touched = met({{-6, 0, 3}, {1, 0, 1}}, tube);  // up and over the upper rim
    expect_hits(touched, Contact::rim, {1});
    EXPECT_FALSE(touched.normal.has_value());
    expect_miss(met({{-6, 0, std::nextafter(3.0, 4.0)}, {1, 0, 1}}, tube), Contact::none);
  }
  expect_hits(met({{-6, 0, -1}, {1, 0, 1}}, open), Contact::rim, {1});
  expect_hits(met({{-6, 0, -1}, {1, 0, 1}}, capped), Contact::rim, {1, 5});  // out through the upper cap
}

TEST(CylinderOracle, HitsTheRimsInTheirPlane) {
  for (const auto& tube : {open, capped}) {
    for (const double z : {0.0, 4.0}) {
      expect_hits(met({{-7, 0, z}, {1, 0, 0}}, tube), Contact::rim, {2, 12});
      expect_hits(met({{5, -3, z}, {0, 1, 0}}, tube), Contact::rim, {3});  // and touches it there
    }
    expect_miss(met({{-7, 0, -DBL_TRUE_MIN}, {1, 0, 0}}, tube), Contact::none);
    expect_miss(met({{-7, 0, std::nextafter(4.0, 5.0)}, {1, 0, 0}}, tube), Contact::none);
  }
}

TEST(CylinderOracle, DistinguishesALineInTheSideFromOneBeside) {
  const Ray<double> in_side{{3, 8, -1}, {0, 0, 1}};
  expect_miss(met(in_side, open), Contact::in_surface);
  expect_hits(met(in_side, capped), Contact::rim, {1, 5});  // the two ends belong to the caps
  EXPECT_FALSE(met(in_side, capped).normal.has_value());
  const Ray<double> beside{{3, std::nextafter(8.0, 9.0), -1}, {0, 0, 1}};
  expect_miss(met(beside, open), Contact::none);
  expect_miss(met(beside, capped), Contact::none);
  const Ray<double> within{{3, std::nextafter(8.0, 7.0), -1}, {0, 0, 1}};
  expect_miss(met(within, open), Contact::none);
  expect_hits(met(within, capped), Contact::crossing, {1, 5});
}

TEST(CylinderOracle, TakesOneOfNoHeightForItsRimOrDisk) {
  const Cylinder<double> ring{5, 10, 0, false}, disk{5, 10, 0, true};
  expect_hits(met({{3, 8, -1}, {0, 0, 1}}, ring), Contact::rim, {1});  // an axis-parallel line through it
  expect_hits(met({{3, 8, -1}, {0, 0, 1}}, disk), Contact::rim, {1});
  expect_miss(met({{1, 1, -1}, {0, 0, 1}}, ring), Contact::none);
  expect_miss(met({{3, 8, 1}, {0, 0, 1}}, ring), Contact::none);  // through it behind the origin
  const RayAnswer flat = met({{1, 1, -1}, {0, 0, 1}}, disk);
  expect_hits(flat, Contact::crossing, {1});
  EXPECT_FALSE(flat.normal.has_value());  // both caps are there, and neither is outward
  for (const auto& tube : {ring, disk}) {
    expect_hits(met({{-7, 0, 0}, {1, 0, 0}}, tube), Contact::rim, {2, 12});
    expect_hits(met({{-7, 0, -2}, {1, 0, 1}}, tube), Contact::rim, {2});
    expect_miss(met({{3, std::nextafter(8.0, 9.0), -1}, {0, 0, 1}}, tube), Contact::none);
  }
}

TEST(CylinderOracle, IncludesBothEndsOfTheInterval) {
  Ray<double> ray{{-7, 0, 1}, {1, 0, 0}, 2, 12};
  expect_hits(met(ray, open), Contact::crossing, {2, 12});
  ray.t_min = std::nextafter(2.0, 3.0);
  const RayAnswer second = met(ray, open);
  expect_hits(second, Contact::crossing, {12});
  EXPECT_EQ(*second.normal, glm::dvec3(1, 0, 0));
  ray.t_max = std::nextafter(12.0, 11.0);
  expect_miss(met(ray, open), Contact::none);
}

TEST(CylinderOracle, RoundsRootsAndTies) {
  const Cylinder<double> round{1, 1, 1, false};
  // 2t² = 1 along the diagonal: t = ±√½.
  const double root = 0x1.6a09e667f3bcdp-1;
  expect_hits(met({{0, 0, 0.5}, {1, 1, 0}, -2, 2}, round), Contact::crossing, {-root, root});
  EXPECT_EQ(met({{0, 0, 0.5}, {1, 1, 0}}, round, Precision::float32).hits.t[0], 0x1.6a09e6p-1);
  const Cylinder<double> tall{0x1p+24, 1, 0x1p+24 + 3, true};
  EXPECT_TRUE(hits_at(met({{0, 0, 0}, {0, 0, 0x1p+24}}, tall, Precision::float32), {0, 1 + 0x1p-22}));
}

TEST(CylinderOracle, BearsSubnormalsAndTheLargestNumbers) {
  for (const double size : {DBL_TRUE_MIN, 0x1p-1000, 0x1p+1000}) {
    const Cylinder<double> tube{5 * size, 10 * size, 4 * size, true};
    expect_hits(met({{3 * size, -9 * size, size}, {0, size, 0}}, tube), Contact::crossing, {1, 17});
    expect_hits(met({{5 * size, -3 * size, size}, {0, size, 0}}, tube), Contact::tangent, {3});
    expect_hits(met({{3 * size, 8 * size, -size}, {0, 0, size}}, tube), Contact::rim, {1, 5});
  }
  const Cylinder<double> needle{DBL_TRUE_MIN, DBL_MAX, DBL_MAX, false};
  expect_hits(met({{-1, 0, 1}, {1, 0, 0}}, needle), Contact::crossing, {1, 1});
}

TEST(CylinderOracle, PointsTheNormalOutwardUnderAMirror) {
  EXPECT_EQ(*met_under(stretch(-1, 1, 1), {{-7, 0, 1}, {1, 0, 0}}, open).normal, glm::dvec3(-1, 0, 0));
  const RayAnswer below = met_under(stretch(1, 1, -1), {{1, 1, -9}, {0, 0, 1}}, capped);
  expect_hits(below, Contact::crossing, {5, 9});
  EXPECT_EQ(*below.normal, glm::dvec3(0, 0, -1));
}

/// How far the verdict "one hit" is from right, at float precision, in units of the contract.
double margin_of_one_hit(const RayQuestion& question) {
  RayAnswer one_hit;
  one_hit.hits.count = 1;
  one_hit.hits.t[0] = 1;
  return judge({.precision = Precision::float32, .question = question}, one_hit).margin;
}

TEST(CylinderOracle, LetsBothHitsOfAThinOneBeOneAlsoAlongTheAxis) {
  const Cylinder<double> coin{3, 3, 0x1p-23, true};
  const Ray<double> slanting{{0, 0, -1}, {1, 0, 1}}, along{{0, 0, -1}, {0, 0, 1}};
  for (const Ray<double>& ray : {slanting, along}) EXPECT_NEAR(margin_of_one_hit({ray, coin}), 1, 0.001);
}

TEST(CylinderOracle, MeasuresAMappedRayWhereItsRoundedDirectionLeadsItBesideTheHeights) {
  const Cylinder<double> mast{1, 1, 0x1p+40, false};
  const Ray<double> leaning{{3, 0, 0}, {0, 0x1p-40, 1}}, upright{{3, 0, 0}, {0, 0, 1}};
  for (const Ray<double>& ray : {leaning, upright}) {
    EXPECT_NEAR(margin_of_one_hit({ray, mast}), 0x1p+24 * 2 / 4, 1);  // from the unit circle at x = 3
    EXPECT_LT(margin_of_one_hit({ray, mast, glm::dmat4(1)}), 0x1p-15);
  }
}

}  // namespace
}  // namespace rayproof::oracle::test
