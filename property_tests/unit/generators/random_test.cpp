#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "generators/draw.hpp"

namespace rayproof {
namespace {

TEST(Random, TheSameSeedGivesTheSameBits) {
  Random a(7), b(7);
  for (int k = 0; k < 100; ++k) EXPECT_EQ(a.bits(), b.bits());
}

TEST(Random, NeighbouringSeedsHaveNothingInCommon) {
  std::set<std::uint64_t> seen;
  for (std::uint64_t seed = 0; seed < 10'000; ++seed) seen.insert(Random(seed).bits());
  EXPECT_EQ(seen.size(), 10'000U);
}

TEST(Random, BetweenReachesBothEndsAndNothingBeyond) {
  Random random(1);
  std::set<int> seen;
  for (int k = 0; k < 1000; ++k) seen.insert(random.between(-2, 3));
  EXPECT_EQ(seen, (std::set<int>{-2, -1, 0, 1, 2, 3}));
}

TEST(Random, UnitIsUniformWithinAPercent) {
  Random random(2);
  double sum = 0;
  for (int k = 0; k < 100'000; ++k) {
    const double x = random.unit();
    ASSERT_GE(x, 0);
    ASSERT_LT(x, 1);
    sum += x;
  }
  EXPECT_NEAR(sum / 100'000, 0.5, 0.01);
}

template <class T>
class Draws : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(Draws, Precisions);

TYPED_TEST(Draws, BitPatternsAreFiniteAndIncludeSubnormalsAndBothSigns) {
  Random random(3);
  bool subnormal = false, negative = false, positive = false;
  for (int k = 0; k < 100'000; ++k) {
    const auto x = draw::bit_pattern<TypeParam>(random);
    ASSERT_TRUE(std::isfinite(x));
    subnormal |= std::fpclassify(x) == FP_SUBNORMAL;
    negative |= x < 0;
    positive |= x > 0;
  }
  EXPECT_TRUE(negative);
  EXPECT_TRUE(positive);
  // A subnormal float comes once in 256 patterns, a subnormal double once in 2048.
  EXPECT_TRUE(subnormal);
}

TYPED_TEST(Draws, SpecialNumbersIncludeZerosOfBothSignsTheGreatestAndTheLeast) {
  Random random(4);
  bool zero = false, minus_zero = false, greatest = false, least = false;
  for (int k = 0; k < 10'000; ++k) {
    const auto x = draw::special<TypeParam>(random);
    ASSERT_TRUE(std::isfinite(x));
    zero |= x == 0 && !std::signbit(x);
    minus_zero |= x == 0 && std::signbit(x);
    greatest |= x == std::numeric_limits<TypeParam>::max();
    least |= x == std::numeric_limits<TypeParam>::denorm_min();
  }
  EXPECT_TRUE(zero && minus_zero && greatest && least);
}

TYPED_TEST(Draws, MagnitudesFillTheirRangeOfExponents) {
  Random random(5);
  std::set<int> exponents;
  for (int k = 0; k < 10'000; ++k) exponents.insert(std::ilogb(draw::magnitude<TypeParam>(random, -20, 20)));
  EXPECT_EQ(exponents.size(), 40U);
}

TYPED_TEST(Draws, NudgedMovesBySoManyNumbersAndStaysFinite) {
  EXPECT_EQ(draw::nudged(TypeParam(1), 1), TypeParam(1) + std::numeric_limits<TypeParam>::epsilon());
  EXPECT_EQ(draw::nudged(draw::nudged(TypeParam(1), 3), -3), TypeParam(1));
  constexpr TypeParam greatest = std::numeric_limits<TypeParam>::max();
  EXPECT_EQ(draw::nudged(greatest, 2), greatest);
}

TEST(Vectors, UnitVectorsHaveLengthOneAndPerpendicularsARightAngle) {
  Random random(6);
  for (int k = 0; k < 1000; ++k) {
    const glm::dvec3 n = draw::unit_vector(random);
    const glm::dvec3 p = draw::perpendicular(random, n);
    EXPECT_NEAR(dot(n, n), 1, 1e-14);
    EXPECT_NEAR(dot(p, p), 1, 1e-14);
    EXPECT_NEAR(dot(n, p), 0, 1e-14);
  }
}

}  // namespace
}  // namespace rayproof
