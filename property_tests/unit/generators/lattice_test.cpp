#include "generators/lattice.hpp"

#include <gtest/gtest.h>

namespace rayproof {
namespace {

using namespace lattice;

WholeVector some_vector(Random& random, int size) {
  return {Whole(random.between(-size, size)), Whole(random.between(-size, size)),
          Whole(random.between(-size, size))};
}

/// A vector without a common factor; one along an axis now and then.
WholeVector some_normal(Random& random) {
  const int size = random.one_in(4) ? 1 : 1 << 20;
  for (;;) {
    const WholeVector n = primitive(some_vector(random, size));
    if (dot(n, n) != 0) return n;
  }
}

TEST(Lattice, ItsPointsLieInThePlaneThatIsAskedForNearThePlaceThatIsGiven) {
  Random random(1);
  for (int k = 0; k < 2000; ++k) {
    const WholeVector n = some_normal(random), from = some_vector(random, 1 << 30);
    const PlaneLattice plane(n);
    const Whole value = dot(n, from) + random.between(-1000, 1000);
    const WholeVector found = plane.point_near(from, value), way = plus(found, -1, from);
    EXPECT_EQ(dot(n, found), value);
    EXPECT_LE(dot(way, way), 2 * dot(n, n) + 1000000) << "no farther than the plane's own spacing";
  }
}

TEST(Lattice, TwoShortVectorsSpanAPlane) {
  Random random(2);
  for (int k = 0; k < 2000; ++k) {
    const PlaneLattice plane(some_normal(random));
    EXPECT_EQ(dot(plane.normal, plane.first), 0);
    EXPECT_EQ(dot(plane.normal, plane.second), 0);
    EXPECT_EQ(dot(plane.normal, plane.unit), 1);
    const WholeVector area = cross(plane.first, plane.second);
    EXPECT_EQ(dot(area, area), dot(plane.normal, plane.normal)) << "all of its whole points";
    EXPECT_LE(2 * abs(dot(plane.first, plane.second)), dot(plane.first, plane.first));
  }
}

TEST(Lattice, AQuotientModuloIsOneThatMultipliesBack) {
  const Whole modulus = Whole(1) << 40;
  for (int a = -99; a < 100; a += 2)
    for (int r = -3; r <= 3; ++r) {
      const Whole x = quotient_modulo(r, a, modulus);
      EXPECT_TRUE(x >= 0 && x < modulus);
      EXPECT_EQ((a * x - r) % modulus, 0);
    }
}

TEST(Lattice, ANumberOfTwiceTheDigitsIsADifferenceOfTwo) {
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    const int digits = draw::digits_of(precision), bits = 3 * digits;
    const Whole steps = (Whole(13) << bits) + (Whole(5) << (bits - 2 * digits + 5));
    const auto [high, low] = difference(precision, steps, bits);
    EXPECT_EQ(high, 13);
    EXPECT_EQ(whole(high, bits) - whole(low, bits), steps);
    EXPECT_EQ(round_to(precision, low), low);
  }
}

TEST(Lattice, WhatIsNotOnAGridIsRoundedToIt) {
  EXPECT_EQ(on_grid(0.3, 2), 0.25);
  EXPECT_EQ(on_grid(glm::dvec3(0.3, -0.4, 5), 2), glm::dvec3(0.25, -0.5, 5));
}

TEST(Lattice, NumbersBecomeStepsAndBackWithoutRounding) {
  for (const double x : {0.0, 1.0, -0.75, 0x1.fffffffffffffp40, 0x1p-90})
    EXPECT_EQ(number(whole(x, 100), 100), x);
  EXPECT_EQ(whole(0x1p-101, 100), 0) << "less than a step";
}

}  // namespace
}  // namespace rayproof
