/// \file
/// Running error bounds of double-doubles: every operation's, by expansions, where numbers are usual and
/// where they are so small that products or remainders underflow; and what is said of special numbers.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <rayproof/arithmetics/bounded.hpp>
#include <rayproof/arithmetics/double_double.hpp>

#include "unit/lib/arithmetics/exact_parts.hpp"

namespace rayproof {
namespace {

using Wide = DoubleDouble<double>;
using BoundedWide = Bounded<Wide>;

/// A number and its error, and a number that it may stand for: its own or one as far off as can be.
struct Doubtful {
  BoundedWide number;
  Expansion<double, 3> meant;
};

/// Numbers that are 2^exponent times smaller than what they are meant to be, with no digit lost on the way.
struct DoubtfulNumbers {
  int exponent;
  std::mt19937_64 bits{11};

  double fraction() { return std::ldexp(static_cast<double>(bits() >> 11U), -52) - 1; }
  double power(unsigned least) { return std::ldexp(1.0, -static_cast<int>(bits() % least)); }
  Doubtful next() {
    const double high = fraction() * power(10);
    const bool has_room = exponent > -900;
    const Wide value = Wide(high) + Wide(has_room ? 0x1p-54 * high * fraction() : 0.0);
    const double error = bits() % 3 == 0 ? 0.0 : std::ldexp(power(has_room ? 110 : 40), std::ilogb(high));
    const double off = bits() % 2 == 0 ? error : -error;
    Wide small = value;
    for (int left = exponent; left < 0; left += 60)
      small = small * Wide(std::ldexp(1.0, std::max(left, -60)));
    return {{small, std::ldexp(error, exponent)}, exact_of(value) + exact(off)};
  }
};

/// The sum of both parts, 2^up times larger.
Expansion<double, 2> enlarged(const Wide& x, int up) {
  return exact(std::ldexp(x.low(), up)) + exact(std::ldexp(x.high(), up));
}

/// Whether z, 2^up times larger, times `divisor` is `wanted` to within its bound.
template <std::size_t N, std::size_t M>
bool is_within_bound(const BoundedWide& z, int up, const Expansion<double, N>& wanted,
                     const Expansion<double, M>& divisor) {
  if (z.error == infinity<double>) return true;
  const auto off = magnitude(enlarged(z.value, up) * divisor - wanted);
  return sign(exact(std::ldexp(z.error, up)) * magnitude(divisor) - off) >= 0;
}

/// The same of a root: both ends of what it may be, squared.
bool is_root_within_bound(const BoundedWide& z, int up, const Expansion<double, 3>& radicand) {
  if (z.error == infinity<double>) return true;
  const auto value = enlarged(z.value, up);
  const auto error = exact(std::ldexp(z.error, up));
  const auto low = value - error, high = value + error;
  return (sign(low) <= 0 || sign(radicand - low * low) >= 0) && sign(high * high - radicand) >= 0;
}

/// Every operation, and that a share of the bounds is finite.
void expect_bounds(int exponent) {
  SCOPED_TRACE(exponent);
  DoubtfulNumbers numbers{exponent};
  const auto one = exact(1.0);
  int finite_quotients = 0, finite_roots = 0;
  for (int i = 0; i < 50'000; ++i) {
    const auto [a, A] = numbers.next();
    const auto [b, B] = numbers.next();
    ASSERT_TRUE(is_within_bound(a + b, -exponent, A + B, one)) << i;
    ASSERT_TRUE(is_within_bound(a - b, -exponent, A - B, one)) << i;
    if (exponent > -500) {
      ASSERT_TRUE(is_within_bound(a * b, -2 * exponent, A * B, one)) << i;
    }
    const BoundedWide quotient = a / b;
    ASSERT_TRUE(is_within_bound(quotient, 0, A, B)) << i;
    finite_quotients += quotient.error < infinity<double> ? 1 : 0;
    if (sign(A) < 0) continue;
    const BoundedWide root = sqrt(a);
    ASSERT_TRUE(is_root_within_bound(root, -exponent / 2, A)) << i;
    finite_roots += root.error < infinity<double> ? 1 : 0;
  }
  EXPECT_GT(finite_quotients, 25'000);
  EXPECT_GT(finite_roots, 15'000);
}

TEST(BoundedDoubleDouble, KeepsTheBoundOfEveryOperation) { expect_bounds(0); }
TEST(BoundedDoubleDouble, KeepsItWhereProductsUnderflow) { expect_bounds(-480); }
TEST(BoundedDoubleDouble, KeepsItWhereRemaindersUnderflow) { expect_bounds(-1010); }

TEST(BoundedDoubleDouble, SaysNothingOfANumberThatHasNoDoubleDouble) {
  for (const double far : {0x1p65, -0x1p-65, 0x1p-1074, not_a_number<double>}) {
    const BoundedWide x(far);
    EXPECT_EQ(x.error, infinity<double>) << far;
    EXPECT_FALSE((x < BoundedWide(1)).certain) << far;
    EXPECT_EQ((x * BoundedWide(0)).error, infinity<double>) << far;
  }
  EXPECT_EQ(BoundedWide(0x1p64).error, 0);
  EXPECT_EQ(BoundedWide(-0.0).error, 0);
}

TEST(BoundedDoubleDouble, IsSurelyBelowInfinityWhereItsErrorIsFinite) {
  const BoundedWide no_end(infinity<double>);
  EXPECT_TRUE((BoundedWide(Wide(1), 5) < no_end).value);
  EXPECT_TRUE((BoundedWide(Wide(1), 5) < no_end).certain);
  EXPECT_FALSE((BoundedWide(Wide(1), infinity<double>) < no_end).certain);
  EXPECT_TRUE((no_end == no_end).certain);
}

TEST(BoundedDoubleDouble, SeesADifferenceInTheLowerPart) {
  const Wide above = Wide(1) + Wide(0x1p-60);
  EXPECT_TRUE((BoundedWide(Wide(1), 0x1p-70) < BoundedWide(above, 0)).certain);
  EXPECT_FALSE((BoundedWide(Wide(1), 0x1p-60) < BoundedWide(above, 0)).certain);
  const auto either = select(BoundedWide(Wide(1), 0x1p-59) < BoundedWide(above, 0), BoundedWide(Wide(1), 0),
                             BoundedWide(above, 0));
  EXPECT_GE(either.error, 0x1p-60);
  EXPECT_LT(either.error, 0x1.1p-60);
}

/// The leading part of such a divisor is larger than its error, but the number is not.
TEST(BoundedDoubleDouble, DividesByNoNumberThatMayBe0) {
  const Wide divisor = Wide(1) - Wide(0x1p-54);
  ASSERT_EQ(divisor.high(), 1);
  EXPECT_EQ((BoundedWide(1) / BoundedWide(divisor, 1 - 0x1p-53)).error, infinity<double>);
}

}  // namespace
}  // namespace rayproof
