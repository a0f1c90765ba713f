/// \file
/// Numbers with a size: the value is the plain one, and the size what it would be without signs.

#include <gtest/gtest.h>

#include <rayproof/arithmetics/sized.hpp>

namespace rayproof {
namespace {

TEST(Sized, HasThePlainValueAndTheSizeThatNothingCancels) {
  const Sized<double> x(3.0), y(-2.0), z(5.0);
  const Sized<double> result = x * y + z - y;
  EXPECT_EQ(result.value, 3.0 * -2.0 + 5.0 - -2.0);
  EXPECT_EQ(result.size, 6.0 + 5.0 + 2.0);
}

TEST(Sized, OfAGivenNumberIsItsMagnitude) {
  EXPECT_EQ(Sized<double>(-7.0).size, 7.0);
  EXPECT_EQ(Sized<double>(-0.0).size, 0.0);
}

TEST(Sized, RunsInTheFormulasOfVectors) {
  const auto a = sized<double>({1, -2, 3}), b = sized<double>({4, 5, -6}), c = sized<double>({-7, 8, 9});
  EXPECT_EQ(dot(a, b).value, 4 - 10 - 18);
  EXPECT_EQ(dot(a, b).size, 4 + 10 + 18);
  EXPECT_EQ(dot(cross(a, b), c).value, dot(cross(vec3<double>(1, -2, 3), {4, 5, -6}), {-7, 8, 9}));
  EXPECT_EQ(dot(cross(a, b), c).size, (12 + 15) * 7 + (12 + 6) * 8 + (5 + 8) * 9);
}

}  // namespace
}  // namespace rayproof
