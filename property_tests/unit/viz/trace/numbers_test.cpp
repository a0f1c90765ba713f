#include "viz/trace/numbers.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace rayproof::viz {
namespace {

using Whole = boost::multiprecision::cpp_int;
using WideDecimal = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<1200>>;

template <class T>
constexpr Precision precision_of = std::is_same_v<T, float> ? Precision::float32 : Precision::float64;

/// A finite number's place among all of its format, 0 and -0 being one: from exponent and significand, not
/// from its bits.
template <class T>
Whole place_of(T x) {
  using Limits = std::numeric_limits<T>;
  constexpr int subnormal_exponent = Limits::min_exponent - 1;
  int exponent = 0;
  const T significand = std::frexp(std::abs(x), &exponent);
  Whole place;
  if (x == 0 || exponent <= subnormal_exponent) {
    place = Whole(std::abs(x) / Limits::denorm_min());
  } else {
    const Whole a_binade = Whole(1) << (Limits::digits - 1);
    place = a_binade * (exponent - subnormal_exponent - 1) + Whole(std::ldexp(significand, Limits::digits));
  }
  return x < 0 ? Whole(-place) : place;
}

template <class T>
Whole distance(T a, T b) {
  return abs(place_of(a) - place_of(b));
}

/// No other double is nearer to the exact count.
template <class T>
void expect_nearest(T a, T b) {
  const Whole exact = distance(a, b);
  const double count = count_ulps(static_cast<double>(a), static_cast<double>(b), precision_of<T>);
  ASSERT_TRUE(std::isfinite(count) && count == std::floor(count)) << a << ' ' << b;
  const auto off = [&](double other) { return Whole(abs(exact - Whole(other))); };
  EXPECT_LE(off(count), off(std::nextafter(count, 0.0))) << a << ' ' << b;
  EXPECT_LE(off(count), off(std::nextafter(count, INFINITY))) << a << ' ' << b;
  if (exact <= (Whole(1) << 53)) {
    EXPECT_EQ(Whole(count), exact) << a << ' ' << b;
  }
}

template <class T>
using Bits = std::conditional_t<std::is_same_v<T, float>, std::uint32_t, std::uint64_t>;

/// Of any bit pattern: subnormals and both signs included.
template <class T>
T any_finite(std::mt19937_64& bits) {
  for (;;) {
    const T x = std::bit_cast<T>(static_cast<Bits<T>>(bits()));
    if (std::isfinite(x)) return x;
  }
}

template <class T>
class UlpsOf : public testing::Test {};
using Formats = testing::Types<float, double>;
TYPED_TEST_SUITE(UlpsOf, Formats);

TYPED_TEST(UlpsOf, RandomPairsAreCountedAsExactArithmeticCounts) {
  std::mt19937_64 bits(1);
  for (int i = 0; i < 10'000; ++i) expect_nearest(any_finite<TypeParam>(bits), any_finite<TypeParam>(bits));
}

TYPED_TEST(UlpsOf, PairsOfAllDistancesAreCountedAsExactArithmeticCounts) {
  std::mt19937_64 bits(2);
  for (int i = 0; i < 10'000; ++i) {
    const auto a = any_finite<TypeParam>(bits);
    const auto width = bits() % std::numeric_limits<Bits<TypeParam>>::digits;
    const auto off = static_cast<Bits<TypeParam>>(bits() & ((std::uint64_t{1} << width) - 1));
    const auto b =
        std::bit_cast<TypeParam>(static_cast<Bits<TypeParam>>(std::bit_cast<Bits<TypeParam>>(a) + off));
    if (std::isfinite(b)) expect_nearest(a, b);
  }
}

TYPED_TEST(UlpsOf, NeighboursAreAsFarApartAsTheStepsBetweenThem) {
  std::mt19937_64 bits(3);
  const auto infinite = std::numeric_limits<TypeParam>::infinity();
  for (int i = 0; i < 2'000; ++i) {
    const auto a = any_finite<TypeParam>(bits);
    TypeParam up = a;
    TypeParam down = a;
    for (int steps = 1; steps <= 20; ++steps) {
      up = std::nextafter(up, infinite);
      down = std::nextafter(down, -infinite);
      if (!std::isfinite(up) || !std::isfinite(down)) break;
      EXPECT_EQ(count_ulps(static_cast<double>(a), static_cast<double>(up), precision_of<TypeParam>), steps);
      EXPECT_EQ(count_ulps(static_cast<double>(a), static_cast<double>(down), precision_of<TypeParam>),
                steps);
      expect_nearest(down, up);
    }
  }
}

TYPED_TEST(UlpsOf, ZeroIsOneNumberBetweenBothSigns) {
  using Limits = std::numeric_limits<TypeParam>;
  const auto count = [](TypeParam a, TypeParam b) {
    return count_ulps(static_cast<double>(a), static_cast<double>(b), precision_of<TypeParam>);
  };
  EXPECT_EQ(count(0, -TypeParam(0)), 0);
  EXPECT_EQ(count(-Limits::denorm_min(), Limits::denorm_min()), 2);
  EXPECT_EQ(count(-TypeParam(0), Limits::denorm_min()), 1);
  EXPECT_EQ(count(0, Limits::min()), std::ldexp(1, Limits::digits - 1));
  expect_nearest(-Limits::max(), Limits::max());
  expect_nearest(Limits::lowest(), -Limits::denorm_min());
}

TYPED_TEST(UlpsOf, NothingFiniteLiesAFiniteWayFromInfinityOrNaN) {
  const auto count = [](double a, double b) { return count_ulps(a, b, precision_of<TypeParam>); };
  EXPECT_EQ(count(INFINITY, INFINITY), 0);
  EXPECT_EQ(count(-INFINITY, INFINITY), INFINITY);
  EXPECT_EQ(count(static_cast<double>(std::numeric_limits<TypeParam>::max()), INFINITY), INFINITY);
  EXPECT_EQ(count(NAN, 1), INFINITY);
  EXPECT_EQ(count(NAN, NAN), INFINITY);
}

TEST(ExactBeside, IsTheNumberItselfWhereNothingWasRounded) {
  EXPECT_EQ(exact_beside(81, 81, 24), "81");
  EXPECT_EQ(exact_beside(-4499.89990234375, -4499.89990234375, 24), "-4499.89990234375");
  EXPECT_EQ(exact_beside(0.2F, 0.2F, 24), "0.20000000298023224");
  EXPECT_EQ(exact_beside(0.1, 0.1, 53), "0.1");
  EXPECT_EQ(exact_beside(0, 0, 53), "0");
}

TEST(ExactBeside, HasTwelveDigitsBesideAFloatAndSeventeenBesideADouble) {
  const Shadow third = Shadow(1) / 3;
  EXPECT_EQ(exact_beside(third, 1.0F / 3, 24), "0.333333333333");
  EXPECT_EQ(exact_beside(third, 1.0 / 3, 53), "0.33333333333333333");
  EXPECT_EQ(exact_beside(-third * 1e20, -1e20 / 3, 53), "-3.3333333333333333e19");
  EXPECT_EQ(exact_beside(third / 1024 / 1024, 0x1p-20 / 3, 53), "3.1789143880208333e-7");
}

TEST(ExactBeside, KeepsZerosSoThatADifferentNumberLooksDifferent) {
  EXPECT_EQ(exact_beside(Shadow(1) / 5, 0.2F, 24), "0.200000000000");
  EXPECT_EQ(exact_beside(20249100, 20249098, 24), "20249100.0000");
}

TEST(ExactBeside, TakesMoreDigitsWhereTheUsualOnesAreTheValues) {
  EXPECT_EQ(exact_beside(Shadow(1) + Shadow(0x1p-66), 1, 53), "1.00000000000000000001");
}

TEST(ExactBeside, OfRandomQuotientsNeverReadsAsTheRoundedOne) {
  std::mt19937_64 bits(4);
  for (int i = 0; i < 3'000; ++i) {
    const double a = static_cast<double>(bits() >> 11);
    const double b = static_cast<double>((bits() >> 11) + 1);
    const Shadow exact = Shadow(a) / Shadow(b);
    const double value = a / b;
    if (exact == Shadow(value)) continue;
    const WideDecimal text(exact_beside(exact, value, 53));
    const WideDecimal truth = WideDecimal(a) / WideDecimal(b);
    EXPECT_NE(text, WideDecimal(value)) << text;
    EXPECT_LE(abs(text - truth), truth * WideDecimal("5.1e-17")) << text;
  }
}

}  // namespace
}  // namespace rayproof::viz
