#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "unit/bits.hpp"
#include "unit/viz/trace/every_method.hpp"
#include "viz/trace/record.hpp"

namespace rayproof::viz {
namespace {

using Rational = boost::multiprecision::cpp_rational;

/// A number of 320 bits is the sum of a few doubles.
Rational rational(Shadow x) {
  Rational sum = 0;
  for (; x != 0; x -= static_cast<double>(x)) sum += Rational(static_cast<double>(x));
  return sum;
}

template <class T>
void expect_plain_results() {
  for_every_recordable_method<T>([]<class Topic, class Method>(const auto& problem) {
    const auto plain = Topic::template solve<Method>(problem);
    const auto recorded = Topic::template solve<Method>(convert<Recorded<T, Shadow>>(problem));
    const auto bounded = Topic::template solve<Method>(convert<Bounded<T>>(problem));
    ASSERT_TRUE(same_bits(plain.lo, recorded.lo.value())) << Method::name;
    ASSERT_TRUE(same_bits(plain.hi, recorded.hi.value())) << Method::name;
    ASSERT_TRUE(same_bits(plain.discriminant, recorded.discriminant.value())) << Method::name;
    ASSERT_TRUE(same_bits(plain.lo, bounded.lo.value)) << Method::name;
    ASSERT_TRUE(same_bits(plain.hi, bounded.hi.value)) << Method::name;
  });
}

TEST(Recorded, RoundsBitForBitAsFloat) { expect_plain_results<float>(); }
TEST(Recorded, RoundsBitForBitAsDouble) { expect_plain_results<double>(); }

TEST(Recorded, TheShadowOfADiscriminantIsItsExactRationalValue) {
  CaseSource source(3);
  for (int i = 0; i < 2000; ++i) {
    const Quadratic<double> q{source.number(30), source.number(30), source.number(30)};
    Tape tape;
    const auto roots = quadratic::Textbook::roots(convert<Recorded<double, Shadow>>(q));
    const Rational exact = Rational(q.b) * Rational(q.b) - 4 * Rational(q.a) * Rational(q.c);
    EXPECT_EQ(rational(roots.discriminant.exact), exact);
  }
}

TEST(Recorded, TheShadowOfARootSolvesTheEquationTo200Bits) {
  CaseSource source(4);
  for (int i = 0; i < 2000; ++i) {
    const Quadratic<double> q{source.number(10), source.number(10), source.number(10)};
    const auto roots = quadratic::CitardauqViete::roots(convert<Recorded<double, Shadow>>(q));
    if (roots.discriminant.exact < 0 || q.a == 0 || q.b == 0) continue;
    for (const Shadow& x : {roots.lo.exact, roots.hi.exact}) {
      const Shadow residual = abs((q.a * x + q.b) * x + q.c);
      EXPECT_LE(residual, ldexp(abs(q.a * x * x) + abs(q.b * x) + abs(Shadow(q.c)), -200));
    }
  }
}

TEST(Recorded, AWidenedNumberLosesNothingOnTheWay) {
  using R = Recorded<float, Shadow>;
  Tape tape;
  const R third = R(1.0F) / R(3.0F);
  const auto wide = widen(third) * widen(R(3.0F));
  const Operation<Shadow>& product = tape.at(wide.id);
  EXPECT_EQ(product.digits, 53);
  EXPECT_GT(product.bits_lost, 25) << "the third's error, in ulps of double";
  EXPECT_LT(product.bits_lost_here, 3);
  const R one = named("one", narrow(wide));
  EXPECT_EQ(tape.at(one.id).digits, 24);
  EXPECT_LE(tape.at(one.id).bits_lost, 1);
}

TEST(Recorded, WritesNothingWhileNothingRecords) {
  const Recorded<float, Shadow> x = 2.0F;
  EXPECT_EQ((x * x).id, unrecorded);
}

TEST(Recorded, AnInnerRecordingLeavesTheOuterOneAlone) {
  Tape outer;
  const Recorded<float, Shadow> x = 2.0F;
  {
    Tape inner;
    (void)sqrt(Recorded<float, Shadow>(9.0F));
    EXPECT_EQ(inner.operations.size(), 2U);
  }
  (void)(x + x);
  EXPECT_EQ(outer.operations.size(), 2U);
}

TEST(BitsLost, CountsHalfAnUlpAsLog2OfOneAndAHalf) {
  const Shadow exact = Shadow(1) + ldexp(Shadow(1), -24);
  EXPECT_NEAR(bits_lost(1.0F, exact), std::log2(1.5), 1e-6);
  EXPECT_EQ(bits_lost(1.0F, Shadow(1)), 0);
}

TEST(BitsLost, IsAllDigitsWhereNothingIsRight) {
  EXPECT_EQ(bits_lost(1.0F, Shadow(0)), 24);
  EXPECT_EQ(bits_lost(std::nanf(""), Shadow(1)), 24);
  EXPECT_EQ(bits_lost(INFINITY, Shadow(1)), 24);
  EXPECT_EQ(bits_lost(1.0, Shadow(-1)), 53);
}

TEST(BitsLost, IsAllDigitsForAnOverflow) { EXPECT_EQ(bits_lost(INFINITY, Shadow(1e39)), 24); }

TEST(BitsLost, IsNothingWhereBothHaveNoValue) {
  EXPECT_EQ(bits_lost(INFINITY, Shadow(INFINITY)), 0);
  EXPECT_EQ(bits_lost(std::nanf(""), Shadow(std::nan(""))), 0);
}

}  // namespace
}  // namespace rayproof::viz
