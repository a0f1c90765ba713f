/// \file
/// A variation of a case is a case.

#include "properties/worst/variation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "case/json/number_text.hpp"
#include "case/reader.hpp"
#include "case/writer.hpp"
#include "generators/generators.hpp"
#include "properties/numbers.hpp"

namespace rayproof::worst {
namespace {

bool is_of_its_precision(Case one) {
  for (const CaseNumber& number : numbers_of(one))
    if (round_to(one.precision, *number.value) != *number.value) return false;
  return true;
}

TEST(Variation, OfEveryFamilyIsACaseThatTheFormatReadsBack) {
  for (const Family& family : families())
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      unsigned changed = 0;
      for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const Case one = family.generate(seed, precision), mate = family.generate(seed + 1, precision);
        Random random(seed);
        const auto other = varied(one, mate, random);
        if (!other) continue;
        const std::string line = write_case(*other);
        EXPECT_EQ(write_case(read_case(line)), line);
        EXPECT_TRUE(is_of_its_precision(*other)) << line;
        EXPECT_EQ(topic_of(*other), family.topic);
        changed += line != write_case(one);
      }
      EXPECT_GE(changed, 8U) << family.topic << "/" << family.name;
    }
}

TEST(Variation, IsTheSameForTheSameRandomNumbers) {
  const Family& family = families().front();
  const Case one = family.generate(1, Precision::float64), mate = family.generate(2, Precision::float64);
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Random first(seed), second(seed);
    const auto a = varied(one, mate, first), b = varied(one, mate, second);
    ASSERT_EQ(a.has_value(), b.has_value());
    EXPECT_TRUE(!a || write_case(*a) == write_case(*b));
  }
}

TEST(Variation, MovesOnAlongTheLastProgress) {
  const Case from{.question = Quadratic<double>{1, 2, 3}}, to{.question = Quadratic<double>{1, 3, 2.5}};
  const auto further = moved_on(from, to, 2);
  ASSERT_TRUE(further);
  EXPECT_EQ(write_case(*further), write_case({.question = Quadratic<double>{1, 5, 1.5}}));
  EXPECT_FALSE(moved_on(from, to, HUGE_VAL)) << "is no number";
  const Case other{.question = PointAndPolygon<double>{{0, 0}, {{0, 0}, {1, 0}, {0, 1}}}};
  EXPECT_FALSE(moved_on(from, other, 1)) << "is of another form";
}

}  // namespace
}  // namespace rayproof::worst
