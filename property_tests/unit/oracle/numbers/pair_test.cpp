/// \file
/// The oracle's third filter: what it knows is exact, and what it can't hold it says it does not know.

#include "oracle/numbers/filters.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "oracle/numbers/exact.hpp"

namespace rayproof::oracle {
namespace {

Ring exactly(const Pair& x) { return Ring(x.high) + Ring(x.low); }

TEST(Pair, holds_what_two_doubles_can_hold) {
  const Pair x = Pair(1.0) + Pair(0x1p-80);
  EXPECT_TRUE(x.is_known());
  EXPECT_EQ(x.high, 1);
  EXPECT_EQ(x.low, 0x1p-80);
  EXPECT_EQ(certain_sign(x), 1);
  const Pair square = Pair(0x1p27 + 1) * Pair(0x1p27 + 1);
  EXPECT_EQ(sign(exactly(square) - Ring(0x1p54) - Ring(0x1p28) - Ring(1.0)), 0);
}

TEST(Pair, is_certain_of_a_zero) {
  const Pair five(5.0), three(3.0), four(4.0);
  EXPECT_EQ(certain_sign(five * five - three * three - four * four), 0);
  EXPECT_EQ(certain_sign(Pair(0.0) * Pair(0x1p-1074)), 0);
}

TEST(Pair, does_not_know_what_takes_three_doubles) {
  EXPECT_EQ(certain_sign(Pair(1.0) + Pair(0x1p-80) + Pair(0x1p-160)), std::nullopt);
  const Pair two_doubles = Pair(1.0) + Pair(0x1p-80);
  EXPECT_EQ(certain_sign(two_doubles * Pair(3.0)), std::nullopt);
}

TEST(Pair, does_not_know_what_overflows_or_underflows) {
  EXPECT_EQ(certain_sign(Pair(0x1p1000) * Pair(0x1p1000)), std::nullopt);
  EXPECT_EQ(certain_sign(Pair(0x1p1023) + Pair(0x1p1023)), std::nullopt);
  EXPECT_EQ(certain_sign(Pair(0x1p-500) * Pair(0x1p-500)), std::nullopt);
  const Pair lost = Pair(0x1p-500) * Pair(0x1p-500);
  EXPECT_EQ(certain_sign(lost - lost), std::nullopt) << "what is unknown stays unknown";
}

TEST(Pair, agrees_with_the_exact_ring_wherever_it_knows) {
  std::mt19937_64 random(2022);
  const auto number = [&] {
    const auto bits = static_cast<double>(random() >> (11 + random() % 50));
    const double sign = random() % 2 == 0 ? 1 : -1;
    return sign * std::ldexp(bits, static_cast<int>(random() % 40) - 20);
  };
  int known = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::array<double, 4> x{number(), number(), number(), number()};
    const Pair result = Pair(x[0]) * Pair(x[1]) - Pair(x[2]) * Pair(x[3]);
    if (!result.is_known()) continue;
    ++known;
    ASSERT_EQ(sign(exactly(result) - Ring(x[0]) * Ring(x[1]) + Ring(x[2]) * Ring(x[3])), 0)
        << x[0] << " * " << x[1] << " - " << x[2] << " * " << x[3];
    ASSERT_EQ(certain_sign(result), sign(exactly(result)));
  }
  EXPECT_GT(known, 5000);
}

}  // namespace
}  // namespace rayproof::oracle
