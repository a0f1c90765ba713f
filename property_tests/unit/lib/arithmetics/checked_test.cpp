#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <rayproof/arithmetics/checked.hpp>

#include "unit/bits.hpp"
#include "unit/viz/trace/every_method.hpp"

namespace rayproof {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Float = Checked<float>;
using Double = Checked<double>;

constexpr float float_inf = infinity<float>, float_nan = not_a_number<float>;
constexpr float ulp = std::numeric_limits<float>::epsilon();

TEST(Checked, HoldsEverySpecialValueExactly) {
  for (const float x : {0.0F, -0.0F, 1.0F, float_inf, -float_inf, float_nan,
                        std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max()}) {
    EXPECT_TRUE(Float(x).is_exact) << x;
    EXPECT_TRUE((-Float(x)).is_exact) << x;
    EXPECT_TRUE(abs(Float(x)).is_exact) << x;
  }
  EXPECT_FALSE(Float(0.1).is_exact) << "0.1 is no float, and this one is the double";
  EXPECT_TRUE(Float(0.1F).is_exact);
  EXPECT_FALSE(Float(16777217).is_exact);
}

TEST(Checked, WhatIeeeCallsInvalidOrADivisionByZeroIsNotRounded) {
  EXPECT_TRUE((Float(float_inf) + Float(1)).is_exact);
  EXPECT_TRUE((Float(float_inf) - Float(float_inf)).is_exact);
  EXPECT_TRUE((Float(float_inf) * Float(0)).is_exact);
  EXPECT_TRUE((Float(1) / Float(0)).is_exact);
  EXPECT_TRUE((Float(0) / Float(0)).is_exact);
  EXPECT_TRUE((Float(1) / Float(float_inf)).is_exact);
  EXPECT_TRUE((Float(float_nan) + Float(1)).is_exact);
  EXPECT_TRUE(sqrt(Float(-1)).is_exact);
  EXPECT_TRUE(sqrt(Float(float_inf)).is_exact);
  EXPECT_TRUE(fma(Float(float_inf), Float(0), Float(1)).is_exact);
  EXPECT_FALSE(sqrt(Float(-1) / Float(3)).is_exact);
}

TEST(Checked, AnOverflowIsRounded) {
  EXPECT_FALSE((Float(3e38F) + Float(3e38F)).is_exact);
  EXPECT_FALSE((Float(3e38F) * Float(2)).is_exact);
  EXPECT_FALSE((Float(3e38F) / Float(0.5F)).is_exact);
  EXPECT_FALSE(fma(Float(3e38F), Float(2), Float(1)).is_exact);
}

TEST(Checked, ZeroIsExactWhereAFactorIsZeroAndNotWhereAProductUnderflows) {
  constexpr float tiny = std::numeric_limits<float>::denorm_min();
  EXPECT_TRUE((Float(0) * Float(tiny)).is_exact);
  EXPECT_TRUE((Float(0) / Float(3)).is_exact);
  EXPECT_FALSE((Float(tiny) * Float(tiny)).is_exact);
  EXPECT_FALSE((Float(tiny) / Float(2)).is_exact);
  EXPECT_TRUE((Float(tiny) - Float(tiny)).is_exact);
  EXPECT_TRUE((Float(1.5F) - Float(1.5F)).is_exact);
}

TEST(Checked, ARoundedOperandIsARoundedResult) {
  const Float third = Float(1) / Float(3);
  EXPECT_FALSE(third.is_exact);
  EXPECT_FALSE((third * Float(3)).is_exact) << "1 by luck";
  EXPECT_FALSE((third * Float(0)).is_exact);
  EXPECT_FALSE((third < Float(1)).is_exact);
  EXPECT_FALSE(fma(third, Float(1), Float(0)).is_exact);
  EXPECT_FALSE(floor(third).is_exact);
  EXPECT_FALSE(max(third, Float(2)).is_exact);
}

TEST(Checked, WhatASelectDiscardsTakesNothing) {
  const Float rounded = Float(1) / Float(3);
  EXPECT_TRUE(select(Float(0) < Float(1), Float(5), rounded).is_exact);
  EXPECT_FALSE(select(Float(0) < Float(1), rounded, Float(5)).is_exact);
  EXPECT_FALSE(select(rounded < Float(1), Float(5), Float(6)).is_exact);
}

TEST(Checked, AMaskIsExactWhereOneExactSideDecides) {
  const CheckedMask yes = true, no = false, rounded{true, false};
  EXPECT_TRUE((no && rounded).is_exact);
  EXPECT_FALSE((yes && rounded).is_exact);
  EXPECT_TRUE((yes || rounded).is_exact);
  EXPECT_FALSE((no || rounded).is_exact);
  EXPECT_TRUE((rounded && false).is_exact);
  EXPECT_FALSE((!rounded).is_exact);
}

TEST(Checked, AnIfThatFollowsARoundedComparisonIsNoted) {
  const Float rounded = Float(1) / Float(3);
  const RoundedDecision outer;
  EXPECT_TRUE(bool(Float(0) < Float(1)));
  EXPECT_FALSE(outer.was_made());
  {
    const RoundedDecision inner;
    EXPECT_TRUE(bool(rounded < Float(1)));
    EXPECT_TRUE(inner.was_made());
  }
  EXPECT_FALSE(outer.was_made()) << "what is decided in a scope within is not this one's";
  EXPECT_TRUE(bool(rounded < Float(1)));
  EXPECT_TRUE(outer.was_made());
}

TEST(Checked, ANumberThatOverflowedDecidesAsARoundedOneDoes) {
  const Float large(0x1p70F);
  const RoundedDecision decision;
  EXPECT_TRUE(is_finite(large));
  EXPECT_FALSE(is_finite(Float(float_inf)));
  EXPECT_FALSE(decision.was_made()) << "infinity as it was given is exact";
  EXPECT_FALSE(is_finite(large * large));
  EXPECT_TRUE(decision.was_made());
}

TEST(Checked, WideNumbersBecomeNarrowExactlyWhereTheyFit) {
  EXPECT_TRUE(narrow(widen(Float(1 + ulp)) * widen(Float(2))).is_exact);
  EXPECT_FALSE(narrow(widen(Float(1 + ulp)) * widen(Float(1 + ulp))).is_exact);
  EXPECT_TRUE((widen(Float(1 + ulp)) * widen(Float(1 + ulp))).is_exact);
}

TEST(Checked, ExponentsAreScaledExactlyWhereTheyCanBeScaledBack) {
  EXPECT_EQ(exponent(Float(0.75F)).value, -1);
  EXPECT_TRUE(exponent(Float(0)).is_exact);
  EXPECT_TRUE(scale_exponent(Float(3), Float(-100)).is_exact);
  EXPECT_FALSE(scale_exponent(Float(3), Float(-150)).is_exact);
  EXPECT_TRUE(scale_exponent(Float(3), Float(-149)).is_exact) << "a subnormal number";
  EXPECT_FALSE(scale_exponent(Float(3), Float(127)).is_exact);
  EXPECT_TRUE(scale_exponent(Float(0), Float(4000)).is_exact);
}

/// A number of few digits or of all, of a size at which nothing over- or underflows.
template <class T>
T some_number(viz::CaseSource& source) {
  const T x = source.rounded<T>(20);
  const int kept = static_cast<int>(source.bits() % 4) * std::numeric_limits<T>::digits / 3;
  if (x == 0 || kept == 0) return static_cast<T>(static_cast<int>(source.bits() % 65) - 32) / 8;
  const int shift = kept - std::ilogb(x);
  return std::ldexp(std::trunc(std::ldexp(x, shift)), -shift);
}

template <class T>
void expect_flags_of_exact_numbers() {
  viz::CaseSource source(7);
  int exact = 0, rounded = 0;
  const auto expect = [&](const Checked<T>& got, bool is_exact) {
    ASSERT_EQ(got.is_exact, is_exact) << got.value;
    ++(is_exact ? exact : rounded);
  };
  for (int i = 0; i < 4000; ++i) {
    const T x = some_number<T>(source), y = some_number<T>(source), w = some_number<T>(source);
    const Checked<T> a = x, b = y, c = w;
    const Rational p(x), q(y), r(w);
    expect(a + b, p + q == Rational((a + b).value));
    expect(a - b, p - q == Rational((a - b).value));
    expect(a * b, p * q == Rational((a * b).value));
    if (y != 0) expect(a / b, p == q * Rational((a / b).value));
    if (x >= 0) expect(sqrt(a), p == Rational(sqrt(a).value) * Rational(sqrt(a).value));
    const Checked<T> fused = fma(a, b, c);
    expect(fused, p * q + r == Rational(fused.value));
  }
  EXPECT_GT(exact, 4000);
  EXPECT_GT(rounded, 4000);
}

TEST(Checked, IsExactJustWhereTheRationalNumberIsForFloats) { expect_flags_of_exact_numbers<float>(); }
TEST(Checked, IsExactJustWhereTheRationalNumberIsForDoubles) { expect_flags_of_exact_numbers<double>(); }

template <class T>
void expect_the_plain_bits() {
  viz::for_every_recordable_method<T>([]<class Topic, class Method>(const auto& problem) {
    const auto plain = Topic::template solve<Method>(problem);
    const auto checked = Topic::template solve<Method>(convert<Checked<T>>(problem));
    ASSERT_TRUE(same_bits(plain.lo, checked.lo.value)) << Method::name;
    ASSERT_TRUE(same_bits(plain.hi, checked.hi.value)) << Method::name;
    ASSERT_TRUE(same_bits(plain.discriminant, checked.discriminant.value)) << Method::name;
  });
}

TEST(Checked, RoundsBitForBitAsFloat) { expect_the_plain_bits<float>(); }
TEST(Checked, RoundsBitForBitAsDouble) { expect_the_plain_bits<double>(); }

}  // namespace
}  // namespace rayproof
