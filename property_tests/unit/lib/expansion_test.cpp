#include <gtest/gtest.h>

#include <rayproof/arithmetics/expansion.hpp>

namespace rayproof {
namespace {

TEST(Expansion, AddsWhatADoubleWouldDrop) {
  const auto sum = exact(1.0) + exact(0x1p-200);
  EXPECT_EQ(estimate(sum), 1.0);
  EXPECT_EQ(estimate(sum - exact(1.0)), 0x1p-200);
}

TEST(Expansion, MultipliesWithoutRounding) {
  const double x = 1 + 0x1p-30;
  const auto square = exact(x) * exact(x);
  EXPECT_EQ(estimate(square - exact(1 + 0x1p-29)), 0x1p-60);
}

TEST(Expansion, KnowsTheSignOfACancelledDifference) {
  const auto a = exact(0.1) * exact(10.0);  // 0.1 is a little more than a tenth
  EXPECT_EQ(sign(a - exact(1.0)), 1);
  EXPECT_EQ(sign(exact(1.0) - a), -1);
  EXPECT_EQ(sign(a - a), 0);
  EXPECT_EQ(estimate(a - a), 0.0);
}

TEST(Expansion, ZeroHasNoTerms) {
  EXPECT_EQ(exact(0.0).count, 0U);
  EXPECT_EQ((exact(0.0) * exact(5.0)).count, 0U);
  EXPECT_EQ((exact(2.0) + exact(-2.0)).count, 0U);
}

TEST(Expansion, StaysWithinTheTermsItsTypeHasRoomFor) {
  auto sum = exact(0x1p+0) + exact(0x1p+60) + exact(0x1p+120) + exact(0x1p+180);
  EXPECT_LE(sum.count, sum.terms.size());
  const auto product = sum * sum;
  EXPECT_LE(product.count, product.terms.size());
  EXPECT_EQ(estimate(product - exact(0x1p+360)),
            estimate(exact(0x1p+301) + exact(0x1p+241) + exact(0x1p+240)));
}

}  // namespace
}  // namespace rayproof
