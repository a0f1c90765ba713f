#include <gtest/gtest.h>

#include <cmath>
#include <rayproof/formulas/exact_rounding.hpp>

namespace rayproof {
namespace {

/// A sum of two doubles in T, from an estimate that may be off by a rounding.
template <class T>
T of_sum(double x, double y) {
  const auto sum = exact(y) + exact(x);
  return correctly_rounded<T>(x + y, [&](const auto& other) { return sign(sum - other); });
}

TEST(ExactRounding, DecidesMidpointsByWhatADoubleCannotHold) {
  const double middle = 1 + 0x1p-24;  // between 1 and the next float
  EXPECT_EQ(of_sum<float>(middle, 0), 1);
  EXPECT_EQ(of_sum<float>(middle, 0x1p-90), 1 + 0x1p-23F);
  EXPECT_EQ(of_sum<float>(middle, -0x1p-90), 1);
  EXPECT_EQ(of_sum<float>(middle + 0x1p-23, -0x1p-90), 1 + 0x1p-23F);
  EXPECT_EQ(of_sum<float>(middle + 0x1p-23, 0), 1 + 0x1p-22F);  // a tie goes to the even one
}

TEST(ExactRounding, DecidesMidpointsOfDoubles) {
  EXPECT_EQ(of_sum<double>(1, 0x1p-53), 1);
  EXPECT_EQ(of_sum<double>(1 + 0x1p-52, 0x1p-53), 1 + 0x1p-51);
  const auto above = exact(0x1p-120) + exact(0x1p-53) + exact(1.0);
  const auto rounded_up = correctly_rounded<double>(1.0, [&](const auto& x) { return sign(above - x); });
  EXPECT_EQ(rounded_up, 1 + 0x1p-52);
}

TEST(ExactRounding, OfADoubleNeedsAnEstimateWithinEightNeighbours) {
  const auto third = exact(0x1p-120) + exact(1.0 / 3);
  for (int ulps = -8; ulps <= 8; ++ulps) {
    const double estimated = 1.0 / 3 + ulps * 0x1p-54;
    EXPECT_EQ(correctly_rounded<double>(estimated, [&](const auto& x) { return sign(third - x); }), 1.0 / 3)
        << ulps;
  }
}

TEST(ExactRounding, OverflowsAtTheMidpointBeyondTheGreatestFloat) {
  const double greatest = std::numeric_limits<float>::max();
  EXPECT_EQ(of_sum<float>(greatest, 0x1p102), greatest);
  EXPECT_EQ(of_sum<float>(greatest, 0x1p103), infinity<float>);
  EXPECT_EQ(of_sum<float>(0x1.ffffffp127, -0x1p10), greatest);
  EXPECT_EQ(of_sum<float>(-0x1.ffffffp127, 0), -infinity<float>);
}

TEST(ExactRounding, RoundsSubnormalsOnce) {
  EXPECT_EQ(of_sum<float>(0x1p-150, 0), 0);
  EXPECT_EQ(of_sum<float>(0x1p-150, 0x1p-300), 0x1p-149F);
  EXPECT_EQ(of_sum<float>(0x3p-150, 0), 0x1p-148F);
}

}  // namespace
}  // namespace rayproof
