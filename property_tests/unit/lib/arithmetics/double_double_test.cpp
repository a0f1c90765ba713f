/// \file
/// Double-doubles: the bound on every operation, by expansions, and what becomes of special numbers.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <rayproof/arithmetics/double_double.hpp>
#include <rayproof/arithmetics/pack.hpp>
#include <rayproof/vec3.hpp>

#include "unit/lib/arithmetics/exact_parts.hpp"

namespace rayproof {
namespace {

using D = DoubleDouble<double>;

constexpr double u = unit_roundoff<D>;

/// |result - wanted| <= bound·|wanted|.
template <std::size_t N, std::size_t M>
bool is_within(double bound, const Expansion<double, N>& result, const Expansion<double, M>& wanted) {
  return sign(exact(bound) * magnitude(wanted) - magnitude(result - wanted)) >= 0;
}

TEST(DoubleDouble, HoldsSumsAndProductsOfTwoDoublesExactly) {
  const D third(1.0 / 3), tiny(0x1.8p-60);
  EXPECT_EQ((third + tiny).high(), 1.0 / 3);
  EXPECT_EQ((third + tiny).low(), 0x1.8p-60);
  EXPECT_EQ(sign(exact_of(third * third) - exact(1.0 / 3) * exact(1.0 / 3)), 0);
  EXPECT_EQ(sign(exact_of(third - tiny) - (exact(1.0 / 3) - exact(0x1.8p-60))), 0);
}

TEST(DoubleDouble, TakesAFiniteNumberWhoseProductsMightOverOrUnderflowForNaN) {
  for (const double far : {0x1.8p64, -0x1p100, 0x1.fp-65, -0x1p-1074}) {
    EXPECT_TRUE(std::isnan(D(far).high())) << far;
  }
  for (const double near : {0x1p64, -0x1p-64, 0.0, 1.0, infinity<double>}) EXPECT_EQ(D(near).high(), near);
  EXPECT_TRUE(std::signbit(D(-0.0).high()));
}

TEST(DoubleDouble, ComparesByBothParts) {
  const D one(1), above = one + D(0x1p-60), below = one - D(0x1p-60);
  EXPECT_TRUE(below < one && one < above && one <= above && one <= one && one != above && above == above);
  EXPECT_FALSE(above < one || one < one || above <= one);
  const D nan(not_a_number<D>);
  EXPECT_FALSE(nan < one || one < nan || nan <= nan || nan == nan);
  EXPECT_TRUE(min(above, below) == below && max(above, below) == above);
  EXPECT_TRUE(abs(-above) == above && abs(below - one) == one - below && abs(D(-0.0)) == D(0));
}

TEST(DoubleDouble, AddsAnErrorAndKeepsThePlaceOfAnInfinity) {
  EXPECT_TRUE(D(1) + 0x1p-90 == D(1) + D(0x1p-50) * D(0x1p-40));
  EXPECT_TRUE(D(1) - 0x1p-90 == D(1) - D(0x1p-50) * D(0x1p-40));
  for (const D error_added : {D(infinity<D>) - 5.0, D(infinity<D>) + 0.0}) {
    EXPECT_TRUE(D(1) < error_added && !(error_added < D(1)) && !(error_added < D(infinity<D>)));
  }
  EXPECT_TRUE(D(-infinity<D>) + 5.0 < D(-1) && !(D(-1) < D(-infinity<D>) + 5.0));
}

TEST(DoubleDouble, TakesTheRootOf0AndOfNoNegativeNumber) {
  EXPECT_TRUE(sqrt(D(0)) == D(0));
  EXPECT_TRUE(sqrt(D(4)) == D(2));
  EXPECT_TRUE(std::isnan(sqrt(D(-4)).high()));
}

TEST(DoubleDouble, IsNarrowedToTheNearestDouble) {
  const D above_a_tie = D(1) + D(0x1p-53);  // halfway to the next double
  EXPECT_EQ(narrowed(above_a_tie, 0x1p-100), 1 + 0x1p-52);
  EXPECT_EQ(narrowed(above_a_tie, -0x1p-100), 1.0);
}

/// Numbers of both parts, of one size or of very different ones, and pairs that nearly cancel.
struct RandomDoubleDoubles {
  std::mt19937_64 bits{7};
  double number() {
    const double fraction = std::ldexp(static_cast<double>(bits() >> 11U), -53) + 1;
    return std::ldexp(bits() % 2 == 0 ? fraction : -fraction, static_cast<int>(bits() % 40) - 20);
  }
  D both() { return D(number()) + D(number()) * D(std::ldexp(1.0, -static_cast<int>(bits() % 60))); }
  D near(const D& x) { return bits() % 2 == 0 ? both() : -(x + x * D(std::ldexp(number(), -30))); }
  /// -x, but for one or two units in the last place of its upper part, and with another lower part.
  D opposite(const D& x) {
    double upper = x.high();
    for (auto steps = bits() % 3; steps > 0; --steps)
      upper = std::nextafter(upper, bits() % 2 == 0 ? 0 : 1e9);
    const double half_ulp = (std::nextafter(std::abs(upper), 1e9) - std::abs(upper)) / 2;
    const double part = std::ldexp(static_cast<double>(bits() >> 11U), -53) * half_ulp;
    return D(-upper) + (bits() % 2 == 0 ? part : -part);
  }
};

/// Whether the upper part is the sum of both, rounded.
bool is_normalized(const D& x) { return x.high() + x.low() == x.high(); }

TEST(DoubleDouble, KeepsTheBoundOfEveryOperation) {
  RandomDoubleDoubles random;
  for (int i = 0; i < 200'000; ++i) {
    const D x = random.both(), y = random.near(x);
    const auto X = exact_of(x), Y = exact_of(y);
    ASSERT_TRUE(is_within(u, exact_of(x * y), X * Y)) << i;
    ASSERT_TRUE(is_within(u, exact_of(x / y) * Y, X)) << i;
    const double error = x.high() * 0x1p-40 * y.high();
    const auto off = magnitude(exact_of(x + error) - (X + exact(error)));
    ASSERT_GE(sign(exact(0x1p-106) * magnitude(X) + exact(0x1p-52) * magnitude(exact(error)) - off), 0) << i;
    const auto root = exact_of(sqrt(abs(x)));
    ASSERT_TRUE(is_within(2 * u, root * root, magnitude(X))) << i;
  }
}

TEST(DoubleDouble, AddsToWithinThreeRoundingsOfTheSizesOfTheTermsHoweverMuchCancels) {
  constexpr double bound = 3.001 * 0x1p-106;
  RandomDoubleDoubles random;
  for (int i = 0; i < 300'000; ++i) {
    const D x = random.both(), y = i % 3 == 0 ? random.opposite(x) : random.near(x);
    const auto X = exact_of(x), Y = exact_of(y);
    const auto allowed = exact(bound) * (magnitude(X) + magnitude(Y));
    ASSERT_GE(sign(allowed - magnitude(exact_of(x + y) - (X + Y))), 0) << i;
    ASSERT_GE(sign(allowed - magnitude(exact_of(x - y) - (X - Y))), 0) << i;
    ASSERT_TRUE(is_normalized(x + y) && is_normalized(x - y)) << i;
    ASSERT_TRUE(x + -x == D(0) && x - x == D(0)) << i;
    ASSERT_EQ(x + y == D(0), sign(X + Y) == 0) << i;
  }
}

TEST(DoubleDouble, SumsThreeProductsToWithinTheBoundOfTheirSizes) {
  constexpr double bound = 21.01 * 0x1p-106;
  RandomDoubleDoubles random;
  for (int i = 0; i < 100'000; ++i) {
    const D a = random.both(), b = random.both(), c = random.both(), e = random.both();
    const D d = i % 2 == 0 ? random.both() : random.opposite(a * b) / c;  // of products that nearly cancel
    const D f = i % 3 == 0 ? D(0) : random.both() * D(0x1p-30);
    const auto ab = exact_of(a) * exact_of(b), cd = exact_of(c) * exact_of(d), ef = exact_of(e) * exact_of(f);
    const D sum = sum_of_products(a, b, c, d, e, f);
    const auto allowed = exact(bound) * (magnitude(ab) + magnitude(cd) + magnitude(ef));
    ASSERT_GE(sign(allowed - magnitude(exact_of(sum) - (ab + cd + ef))), 0) << i;
    ASSERT_TRUE(is_normalized(sum)) << i;
  }
}

TEST(DoubleDouble, IsTheSameBitForBitInPacks) {
  using P = Pack<double>;
  RandomDoubleDoubles random;
  for (int i = 0; i < 1000; ++i) {
    const double a = random.number(), b = random.number(), c = random.number();
    const auto formula = []<class T>(const T& x, const T& y, const T& z) {
      return select(x < y, sqrt(abs(x * y + z)) / z, min(abs(x), max(y, z)) - x * z);
    };
    const D plain = formula(D(a), D(b), D(c));
    const DoubleDouble<P> pack = formula(DoubleDouble<P>(P(a)), DoubleDouble<P>(P(b)), DoubleDouble<P>(P(c)));
    ASSERT_EQ(pack.high().lanes()[P::size - 1], plain.high());
    ASSERT_EQ(pack.low().lanes()[P::size - 1], plain.low());
  }
}

TEST(DoubleDouble, RunsInTheFormulasOfVectors) {
  const Vec3<D> a = convert<D>(vec3<double>(1, -2, 3)), b = convert<D>(vec3<double>(4, 5, -6));
  EXPECT_TRUE(dot(a, b) == D(4 - 10 - 18));
  const auto n = leading(cross(a, b));
  EXPECT_EQ(n, cross(vec3<double>(1, -2, 3), vec3<double>(4, 5, -6)));
}

}  // namespace
}  // namespace rayproof
