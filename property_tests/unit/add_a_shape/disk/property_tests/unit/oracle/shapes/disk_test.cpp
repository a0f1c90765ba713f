/// \file
/// The oracle's answers to rays and disks, proved by hand.

#include "unit/oracle/cases.hpp"

namespace rayproof::oracle::test {
namespace {

const Disk<double> five_wide{{0, 0, 0}, {0, 0, 2}, 5};

TEST(DiskOracle, CountsTheRimAndSaysSo) {
  expect_hits(met(down(3, 4), five_wide), Contact::rim, {2});
  expect_hits(met(down(3, 3.9), five_wide), Contact::crossing, {2});
  expect_miss(met(down(3, std::nextafter(4.0, 5.0)), five_wide), Contact::none);
}

TEST(DiskOracle, DistinguishesARayInThePlaneFromOneBesideIt) {
  expect_miss(met({{0, 0, 0}, {1, 0, 0}}, five_wide), Contact::in_surface);
  expect_miss(met({{0, 0, 1}, {1, 0, 0}}, five_wide), Contact::parallel);
}

TEST(DiskOracle, TakesARadiusOfZeroForAPoint) {
  expect_hits(met(down(1, 0), Disk<double>{{1, 0, 0}, {0, 0, 1}, 0}), Contact::rim, {2});
  expect_miss(met(down(0, 0), Disk<double>{{1, 0, 0}, {0, 0, 1}, 0}), Contact::none);
}

TEST(DiskOracle, MakesAnEllipseOfItUnderAStretch) {
  expect_hits(met_under(stretch(2, 1, 1), down(6, 4), five_wide), Contact::rim, {2});
  expect_miss(met_under(stretch(2, 1, 1), down(6.5, 4), five_wide), Contact::none);
}

TEST(DiskOracle, GivesTheNormalAlongTheGivenOneFromEitherSide) {
  EXPECT_EQ(met(down(0, 0), five_wide).normal, glm::dvec3(0, 0, 1));
  EXPECT_EQ(met({{0, 0, -2}, {0, 0, 1}}, five_wide).normal, glm::dvec3(0, 0, 1));
}

}  // namespace
}  // namespace rayproof::oracle::test
