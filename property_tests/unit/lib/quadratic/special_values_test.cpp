/// \file
/// The quadratic methods on named special equations.

#include <gtest/gtest.h>

#include <rayproof/quadratic/methods.hpp>

namespace rayproof::quadratic {
namespace {

template <class T>
class FullRangeOf : public testing::Test {
 protected:
  static QuadraticAnswer<T> solve(T a, T b, T c) {
    return read(Quadratic<T>{a, b, c}, FullRange::roots(Quadratic<T>{a, b, c}));
  }
  static void expect_roots(const QuadraticAnswer<T>& found, T lo, T hi) {
    ASSERT_EQ(found.kind, RootKind::two);
    EXPECT_EQ(found.roots[0], lo);
    EXPECT_EQ(found.roots[1], hi);
  }
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(FullRangeOf, Precisions);

TYPED_TEST(FullRangeOf, NamesEachKind) {
  EXPECT_EQ(this->solve(1, -3, 2).kind, RootKind::two);
  EXPECT_EQ(this->solve(1, -2, 1).kind, RootKind::twice);
  EXPECT_EQ(this->solve(1, 0, 1).kind, RootKind::none);
  EXPECT_EQ(this->solve(0, 2, 1).kind, RootKind::linear);
  EXPECT_EQ(this->solve(0, 0, 1).kind, RootKind::constant);
  EXPECT_EQ(this->solve(0, 0, 0).kind, RootKind::everything);
}

TYPED_TEST(FullRangeOf, SolvesCoefficientsThatOverflowWhenSquared) {
  const TypeParam huge = std::ldexp(TypeParam(1), std::numeric_limits<TypeParam>::max_exponent - 3);
  this->expect_roots(this->solve(huge, -3 * huge, 2 * huge), 1, 2);
}

TYPED_TEST(FullRangeOf, SolvesCoefficientsThatUnderflowWhenSquared) {
  const TypeParam tiny = std::numeric_limits<TypeParam>::denorm_min();
  this->expect_roots(this->solve(tiny, -3 * tiny, 2 * tiny), 1, 2);
}

TYPED_TEST(FullRangeOf, DistinguishesADoubleRootFromItsNeighbours) {
  const TypeParam one = 1;
  EXPECT_EQ(this->solve(1, -2, one).kind, RootKind::twice);
  EXPECT_EQ(this->solve(1, -2, std::nextafter(one, TypeParam(2))).kind, RootKind::none);
  EXPECT_EQ(this->solve(1, -2, std::nextafter(one, TypeParam(0))).kind, RootKind::two);
}

TYPED_TEST(FullRangeOf, GivesZeroTwiceWhereOnlyAIsLeft) {
  const auto found = this->solve(1, 0, 0);
  EXPECT_EQ(found.kind, RootKind::twice);
  EXPECT_EQ(found.roots[0], 0);
}

TYPED_TEST(FullRangeOf, OverflowsOnlyWhereTheRootDoes) {
  const TypeParam tiny = std::numeric_limits<TypeParam>::denorm_min();
  const auto found = this->solve(0, tiny, 1);
  ASSERT_EQ(found.kind, RootKind::linear);
  ASSERT_EQ(found.count, 1U);
  EXPECT_EQ(found.roots[0], -infinity<TypeParam>);
}

TYPED_TEST(FullRangeOf, HasNoRootForNaN) {
  const TypeParam nan = not_a_number<TypeParam>;
  EXPECT_EQ(this->solve(nan, 1, 1).count, 0U);
  EXPECT_EQ(this->solve(1, nan, 1).count, 0U);
  EXPECT_EQ(this->solve(1, 1, nan).count, 0U);
  EXPECT_EQ(this->solve(0, 1, nan).count, 0U);
  EXPECT_EQ(this->solve(nan, 1, 0).count, 0U);
}

// By hand, planted in the textbook's formula: no property had anything to see where they were left out.
TEST(RootsOutOfOrder, AreGivenAsTheyStand) {
  const auto answer = read(Quadratic<double>{-1, 3, -2}, Roots<double>{1, 2, 1});
  EXPECT_EQ(answer.kind, RootKind::two);
  ASSERT_EQ(answer.count, 2U);
  EXPECT_EQ(answer.roots[0], 2);
  EXPECT_EQ(answer.roots[1], 1);
}

TEST(Cancellation, CostsTheTextbookFormulaItsSmallRootAndNotTheStableOnes) {
  const Quadratic<float> q{1, 1e4F, 1};  // roots near -1e4 and -1e-4
  EXPECT_EQ(Textbook::roots(q).hi, 0);
  EXPECT_FLOAT_EQ(CitardauqViete::roots(q).hi, -1e-4F);
  EXPECT_FLOAT_EQ(Kahan::roots(q).hi, -1e-4F);
  EXPECT_FLOAT_EQ(Citardauq::roots(q).lo, -1e-4F);
  EXPECT_EQ(Citardauq::roots(q).hi, infinity<float>);  // -1e4 divided by a 0 of no sign
}

TEST(Cancellation, HidesADoubleRootFromEveryDiscriminantButKahans) {
  // b² - 4ac = 1 where b² alone needs more digits than a double has (W. Kahan).
  const Quadratic<double> q{94906265.625, -189812534, 94906268.375};
  EXPECT_EQ(Textbook::roots(q).discriminant, 0);
  EXPECT_GT(Kahan::roots(q).discriminant, 0);
}

TEST(Citardauq, KeepsOneRootWhereAVanishes) {
  EXPECT_EQ(Citardauq::roots(Quadratic<float>{0, 2, 1}).lo, -0.5F);
  EXPECT_EQ(Citardauq::roots(Quadratic<float>{0, -2, 1}).lo, 0.5F);
}

}  // namespace
}  // namespace rayproof::quadratic
