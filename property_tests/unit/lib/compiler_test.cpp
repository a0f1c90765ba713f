/// \file
/// What every result here rests on: that the compiler rounds where the source says so.

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace {

/// Out of line, so that the compiler can't compute the answers itself.
[[gnu::noinline]] std::array<double, 2> narrow_both(const std::array<double, 2>& x) {
  return {static_cast<double>(static_cast<float>(x[0])), static_cast<double>(static_cast<float>(x[1]))};
}

[[gnu::noinline]] double multiply_add(double x, double y, double z) { return x * y + z; }

// g++ 12.2 at -O2 leaves both numbers unrounded unless its basic-block vectorizer is off.
TEST(Compiler, RoundsTwoNeighbouringDoublesToFloat) {
  const std::array<double, 2> rounded = narrow_both({1.1, 2.2});
  EXPECT_EQ(rounded[0], 0x1.19999ap+0);
  EXPECT_EQ(rounded[1], 0x1.19999ap+1);
}

TEST(Compiler, DoesNotContractAProductAndASum) {
  const double x = 1 + 0x1p-30;
  EXPECT_EQ(multiply_add(x, x, -(1 + 0x1p-29)), 0.0);
}

TEST(Compiler, KeepsNaNInfinityAndSubnormals) {
  volatile double tiny = std::numeric_limits<double>::denorm_min();
  volatile double zero = 0;
  EXPECT_GT(tiny, 0.0);
  EXPECT_NE(zero / zero, zero / zero);
  EXPECT_GT(1 / zero, std::numeric_limits<double>::max());
}

}  // namespace
