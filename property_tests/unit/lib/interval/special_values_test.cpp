/// \file
/// Intervals and dual numbers on the special values of their arithmetic, by name.

#include <gtest/gtest.h>

#include <rayproof/arithmetics/dual.hpp>
#include <rayproof/quadratic/textbook.hpp>
#include <rayproof/sphere/centred.hpp>

namespace rayproof {
namespace {

using I = Interval<double>;
constexpr double inf = infinity<double>;
constexpr double nan = not_a_number<double>;
constexpr double most = std::numeric_limits<double>::max();
constexpr double least = std::numeric_limits<double>::denorm_min();

void expect_ends(const I& x, double lo, double hi) {
  EXPECT_EQ(x.lo, lo);
  EXPECT_EQ(x.hi, hi);
}

TEST(IntervalAt, NaNIsNoNumberAndStaysNone) {
  const I empty(nan);
  EXPECT_TRUE(empty.is_empty());
  for (const I& x :
       {empty + I(1), I(1) - empty, empty * I(0), I(0) * empty, I(1) / empty, empty / I(1), sqrt(empty),
        square(empty), abs(empty), min(I(1), empty), max(empty, I(1)), copysign(I(1), empty)})
    EXPECT_TRUE(x.is_empty());
  EXPECT_TRUE((empty < I(1)).fails_for_certain());
  EXPECT_TRUE((empty >= I(1)).fails_for_certain());
  EXPECT_TRUE((empty == empty).fails_for_certain());
  EXPECT_TRUE((empty != empty).holds_for_certain());
}

TEST(IntervalAt, InfinityIsEveryNumberTooLarge) {
  expect_ends(I(inf), most, inf);
  expect_ends(I(-inf), -inf, -most);
  expect_ends(I(most) + I(most), most, inf);
  expect_ends(I(-most) * I(2), -inf, -most);
  EXPECT_TRUE((I(inf) - I(inf)).contains(0));
  expect_ends(I::whole() * I(0), 0, 0);
}

TEST(IntervalAt, ZeroAsADivisorIsLeftOut) {
  EXPECT_TRUE((I(1) / I(0)).is_empty());
  EXPECT_TRUE((I(0) / I(0)).is_empty());
  expect_ends(I(1) / I::between(0, 2), 0.5, inf);
  expect_ends(I(1) / I::between(-2, 0), -inf, -0.5);
  expect_ends(I(-1) / I::between(0, 2), -inf, -0.5);
  expect_ends(I::between(-1, 1) / I::between(0, 2), -inf, inf);
  expect_ends(I(1) / I::between(-1, 1), -inf, inf);
  expect_ends(I(1) / I::between(2, inf), 0, 0.5);
}

TEST(IntervalAt, SubnormalsKeepTheirSign) {
  expect_ends(I(least) * I(least), 0, least);
  expect_ends(I(least) * I(-least), -least, 0);
  expect_ends(I(least) / I(4), 0, least);
  EXPECT_EQ((I(least) + I(-least)).lo, 0);
}

TEST(IntervalAt, MinusZeroIsZero) {
  EXPECT_TRUE((I(-0.0) == I(0)).holds_for_certain());
  expect_ends(I(-0.0) * I::between(-3, 5), 0, 0);
  EXPECT_TRUE((I(1) / I(-0.0)).is_empty());
}

TEST(IntervalAt, RootsOfNegativeNumbersAreLeftOut) {
  EXPECT_TRUE(sqrt(I(-1)).is_empty());
  expect_ends(sqrt(I::between(-1, 4)), 0, 2);
  expect_ends(sqrt(I::between(0, inf)), 0, inf);
}

TEST(IntervalAt, ASquareIsTighterThanAProduct) {
  const I x = I::between(-1, 2);
  expect_ends(square(x), 0, 4);
  expect_ends(x * x, -2, 4);
}

TEST(IntervalAt, AnInexactConstantIsTheTwoFloatsBesideIt) {
  const Interval<float> tenth(0.1);
  EXPECT_LT(double{tenth.lo}, 0.1);
  EXPECT_GT(double{tenth.hi}, 0.1);
  EXPECT_EQ(outward::above(tenth.lo), tenth.hi);
}

TEST(IntervalAt, AnUncertainChoiceIsBoth) {
  const auto chosen = select(I::between(1, 3) < I(2), I(10), I(20));
  expect_ends(chosen, 10, 20);
  expect_ends(select(I(1) < I(2), I(10), I(20)), 10, 10);
  expect_ends(select(I(3) < I(2), I(10), I(20)), 20, 20);
}

TEST(IntervalAt, EveryMiddleIsInside) {
  for (const I& x : {I(0), I::whole(), I::between(0, inf), I::between(-inf, -5), I::between(-most, most),
                     I::between(most / 2, most), I::between(least, least), I(inf), I::between(1, 3)})
    EXPECT_TRUE(x.contains(x.middle())) << x.lo << " " << x.hi;
}

TEST(IntervalArithmetic, RunsTheSphereKernelAroundItsExactRoots) {
  const Ray<I> ray{{I(0), I(0), I(-5)}, {I(0), I(0), I(1)}, I(0), I(inf)};
  const Roots<I> roots = sphere::Centred::roots(ray, Sphere<I>{{I(0), I(0), I(0)}, I(1)});
  expect_ends(roots.lo, 4, 4);
  expect_ends(roots.hi, 6, 6);
  EXPECT_TRUE(in_interval(ray, roots.lo).holds_for_certain());
}

TEST(IntervalArithmetic, SaysWhereAFormulaHasNoValue) {
  const auto roots = quadratic::Textbook::roots(Quadratic<I>{I(1), I(0), I(1)});
  EXPECT_TRUE(roots.lo.is_empty());
  EXPECT_TRUE((roots.discriminant < I(0)).holds_for_certain());
}

TEST(Dual, DifferentiatesEveryOperation) {
  const auto x = variable(3.0);
  const auto y = (square(x) - Dual<double>(1)) / (x + Dual<double>(1)) * x;  // (x - 1)·x
  EXPECT_EQ(y.value, 6);
  EXPECT_EQ(y.slope, 5);
  EXPECT_EQ(sqrt(variable(4.0)).slope, 0.25);
  EXPECT_EQ((-x).slope, -1);
  EXPECT_EQ(select(x < Dual<double>(4), x, -x).slope, 1);
}

TEST(Dual, EnclosesTheSlopeOverAWholeInterval) {
  const auto x = variable(I::between(1, 2));
  const auto cube = square(x) * x;
  EXPECT_TRUE(cube.slope.contains(I::between(3, 12)));
}

}  // namespace
}  // namespace rayproof
