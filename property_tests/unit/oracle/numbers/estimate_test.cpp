#include <gtest/gtest.h>

#include <cmath>

#include "generators/draw.hpp"
#include "oracle/numbers/exact.hpp"
#include "unit/oracle/doubtful.hpp"

using namespace rayproof;
using namespace rayproof::oracle;

namespace {

/// Whether an estimate's own bound holds of the exact number; one that overflowed claims nothing.
bool is_within_its_bound(const Estimate& estimate, const Exact& exact) {
  const double radius = estimate.radius();
  if (!std::isfinite(radius) || !std::isfinite(estimate.high)) return true;
  const Exact off = exact - Exact(estimate.high) - Exact(estimate.low);
  return (off.sign() < 0 ? -off : off) <= Exact(radius);
}

/// A random expression of sums, differences and products, computed in both.
struct Both {
  Estimate estimate;
  Exact exact;
};
Both expression(Random& random, int depth, double exponent) {
  if (depth == 0) {
    const double x =
        random.one_in(8) ? random.between(-2, 2) : draw::magnitude<double>(random, -exponent, exponent);
    return {Estimate(x), Exact(x)};
  }
  const Both a = expression(random, depth - 1, exponent), b = expression(random, depth - 1, exponent);
  const int kind = random.between(0, 3);
  if (kind == 0) return {a.estimate + b.estimate, a.exact + b.exact};
  if (kind == 1) return {a.estimate - b.estimate, a.exact - b.exact};
  return {a.estimate * b.estimate, a.exact * b.exact};
}

TEST(Estimate, HoldsTheExactNumberWithinItsBound) {
  for (const double exponent : {1.0, 30.0, 200.0, 400.0, 1000.0}) {
    Random random(7);
    for (int k = 0; k < 4000; ++k) {
      const Both both = expression(random, random.between(1, 5), exponent);
      EXPECT_TRUE(is_within_its_bound(both.estimate, both.exact))
          << "exponent " << exponent << ", case " << k;
    }
  }
}

TEST(Estimate, KnowsNoSignButTheRightOne) {
  for (const double exponent : {1.0, 30.0, 300.0}) {
    Random random(8);
    int known = 0;
    for (int k = 0; k < 4000; ++k) {
      const Both both = expression(random, random.between(1, 4), exponent);
      const auto sign = certain_sign(both.estimate);
      EXPECT_EQ(sign.value_or(both.exact.sign()), static_cast<int>(both.exact.sign()));
      known += sign ? 1 : 0;
    }
    EXPECT_GT(known, 3000);
  }
}

TEST(Estimate, IsCertainOfAZeroThatNothingWasComputedFor) {
  EXPECT_EQ(certain_sign(Estimate(0.0)), 0);
  EXPECT_FALSE(certain_sign(Estimate(0.1) - Estimate(0.1)));
}

TEST(Ring, IsAnEstimateWhereItsThreadFilters) {
  EXPECT_TRUE(Ring(2.0).is_exact());
  {
    const Filtering by_estimates;
    const Ring x(0.1);
    EXPECT_FALSE((x * x).is_exact());
    EXPECT_TRUE(test::is_doubtful([&] { return sign(x - x); }));
    EXPECT_TRUE(test::is_doubtful([&] { return approximate(x * x - x * Ring(0.1) + Ring(0x1p-100)); }));
    EXPECT_FALSE(test::is_doubtful([&] { return sign(x) + sign(approximate(x * x)); }));
  }
  EXPECT_EQ(sign(Ring(0.1) - Ring(0.1)), 0);
}

}  // namespace
