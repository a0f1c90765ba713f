#include <gtest/gtest.h>

#include <cmath>
#include <rayproof/arithmetics/growing_expansion.hpp>

namespace rayproof {
namespace {

using Exact = GrowingExpansion<double>;

TEST(GrowingExpansion, KeepsEveryTermOfALongSum) {
  Exact sum;
  for (int i = -480; i <= 480; i += 60) sum.add(std::ldexp(1.0, i));
  EXPECT_EQ(sum.terms().size(), 17U);
  for (int i = 480; i >= -480; i -= 60) sum.add(-std::ldexp(1.0, i));
  EXPECT_EQ(sign(sum), 0);
}

TEST(GrowingExpansion, HoldsSumsOfMoreNumbersThanItHasTerms) {
  Exact sum;
  for (int i = 0; i < 2000; ++i) sum.add(std::ldexp(1.0, i % 2 == 0 ? i - 1000 : -i));
  for (int i = 1999; i >= 0; --i) sum.add(-std::ldexp(1.0, i % 2 == 0 ? i - 1000 : -i));
  EXPECT_EQ(sign(sum), 0);
}

TEST(GrowingExpansion, EstimatesToAnUlp) {
  EXPECT_EQ(estimate(Exact(1.0) + Exact(0x1p-60)), 1);
  EXPECT_EQ(estimate(Exact(0x1p-60) - Exact(0x1p-200)), 0x1p-60);
  EXPECT_EQ(estimate(Exact()), 0);
}

TEST(GrowingExpansion, MultipliesWithoutRounding) {
  const Exact x = Exact(1.0) + Exact(0x1p-200);
  const Exact rest = x * x - Exact(1.0) - Exact(0x1p-199);
  ASSERT_EQ(rest.terms().size(), 1U);
  EXPECT_EQ(rest.terms()[0], 0x1p-400);
}

TEST(GrowingExpansion, ComparesMagnitudesExactly) {
  const Exact more = Exact(-1.0) - Exact(0x1p-300);
  EXPECT_TRUE(abs(more) > Exact(1.0));
  EXPECT_FALSE(abs(more) > abs(more));
  EXPECT_FALSE(Exact(1.0) > abs(more));
}

TEST(GrowingExpansion, CompressedKeepsTheValueInFewTerms) {
  Exact sum;
  for (int i = 0; i < 100; ++i) sum.add(std::ldexp(1.0, -i));  // one run of a hundred ones
  const auto compact = compressed<4>(sum);
  EXPECT_LE(compact.count, 2U);
  Exact rest = sum;
  for (std::size_t i = 0; i < compact.count; ++i) rest.add(-compact.terms[i]);
  EXPECT_EQ(sign(rest), 0);
  EXPECT_EQ(compressed<4>(Exact()).count, 0U);
}

}  // namespace
}  // namespace rayproof
