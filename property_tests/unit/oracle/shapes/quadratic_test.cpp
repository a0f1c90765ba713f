/// \file
/// Cases of the quadratic oracle whose answers are proved by hand.

#include <gtest/gtest.h>

#include <cfloat>

#include "unit/oracle/cases.hpp"

namespace rayproof::oracle::test {
namespace {

TEST(QuadraticOracle, NamesEachKind) {
  EXPECT_EQ(roots_of(1, -3, 2).kind, RootKind::two);
  EXPECT_EQ(roots_of(1, -2, 1).kind, RootKind::twice);
  EXPECT_EQ(roots_of(1, 0, 1).kind, RootKind::none);
  EXPECT_EQ(roots_of(0, 2, 1).kind, RootKind::linear);
  EXPECT_EQ(roots_of(0, 0, 1).kind, RootKind::constant);
  EXPECT_EQ(roots_of(0, 0, 0).kind, RootKind::everything);
}

TEST(QuadraticOracle, ListsRootsAscendingWhateverTheSignOfA) {
  for (const double sign : {1.0, -1.0}) {
    const auto found = roots_of(sign * 1, sign * -3, sign * 2);
    ASSERT_EQ(found.count, 2U);
    EXPECT_EQ(found.roots[0], 1);
    EXPECT_EQ(found.roots[1], 2);
  }
}

TEST(QuadraticOracle, DistinguishesADoubleRootFromItsNeighbours) {
  const double b = 1 + 0x1p-30;
  EXPECT_EQ(roots_of(1, -2, 1).count, 1U);
  EXPECT_EQ(roots_of(1, -2, std::nextafter(1.0, 2.0)).kind, RootKind::none);
  EXPECT_EQ(roots_of(1, -2, std::nextafter(1.0, 0.0)).kind, RootKind::two);
  EXPECT_EQ(roots_of(1, -2 * b, b * b).kind, RootKind::two);  // b² rounds down by 2^-60
}

TEST(QuadraticOracle, RoundsTheRootsOfTwo) {
  const auto found = roots_of(1, 0, -2);
  EXPECT_EQ(found.roots[1], 0x1.6a09e667f3bcdp+0);
  EXPECT_EQ(roots_of(1, 0, -2, Precision::float32).roots[1], 0x1.6a09e6p+0);
}

TEST(QuadraticOracle, KeepsTheSmallRootThatCancels) {
  const auto found = roots_of(1, 1e20, 1);
  EXPECT_EQ(found.roots[0], -1e20);
  EXPECT_EQ(found.roots[1], -1e-20);
}

TEST(QuadraticOracle, BearsSubnormalsAndTheLargestNumbers) {
  const auto large = roots_of(DBL_TRUE_MIN, -DBL_MAX, DBL_TRUE_MIN);
  ASSERT_EQ(large.count, 2U);
  EXPECT_EQ(large.roots[0], 0);
  EXPECT_TRUE(std::isinf(large.roots[1]));
  EXPECT_EQ(roots_of(DBL_TRUE_MIN, 0, -DBL_TRUE_MIN).roots[1], 1);
}

TEST(QuadraticOracle, RoundsTiesToEven) {
  // 1 + 2^-24 lies halfway between 1 and 1 + 2^-23; 1 + 3·2^-24 halfway to 1 + 2^-22.
  EXPECT_EQ(roots_of(0, 2, -(1 + 0x1p-23), Precision::float32).roots[0], 0.5 + 0x1p-24);
  EXPECT_EQ(roots_of(0, 0x1p+24, -(0x1p+24 + 1), Precision::float32).roots[0], 1);
  EXPECT_EQ(roots_of(0, 0x1p+24, -(0x1p+24 + 3), Precision::float32).roots[0], 1 + 0x1p-22);
}

}  // namespace
}  // namespace rayproof::oracle::test
