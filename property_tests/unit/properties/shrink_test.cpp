#include "properties/shrink.hpp"

#include <gtest/gtest.h>

#include "case/writer.hpp"
#include "generators/generators.hpp"
#include "properties/numbers.hpp"
#include "properties/simplicity.hpp"
#include "properties/validity.hpp"
#include "unit/properties/broken_subjects.hpp"

namespace rayproof {
namespace {

unsigned most_digits(Case one) {
  unsigned most = 0;
  for (const CaseNumber& number : numbers_of(one))
    most = std::max(most, significant_digits(*number.value, one.precision));
  return most;
}

const Family& family(const std::string& topic, const std::string& name) {
  for (const Family& candidate : families())
    if (candidate.topic == topic && candidate.name == name) return candidate;
  throw std::runtime_error("no family " + name);
}

/// The shrunk form of the first case of the family that breaks the property; ends the test where none does.
Case shrunk(const char* subject_name, const char* property_name, const Family& from, Precision precision) {
  const Subject& subject = *find_subject(subject_name);
  const Property& property = *find_property(property_name);
  for (std::uint64_t seed = 0; seed < 100'000; ++seed) {
    const Case one = from.generate(seed, precision);
    Trial trial(subject, one);
    if (property.rule(trial) != Ruling::broken) continue;
    const Case small = shrink(one, striking_break(subject, property, trial));
    Trial again(subject, small);
    EXPECT_EQ(property.rule(again), Ruling::broken) << write_case(small);
    EXPECT_TRUE(is_valid(small));
    return small;
  }
  ADD_FAILURE() << "nothing breaks " << property_name;
  return {};
}

struct Expected {
  const char* subject;
  const char* property;
  const char* topic;
  const char* family;
};

class ReadableCounterexample : public testing::TestWithParam<std::tuple<Expected, Precision>> {};

TEST_P(ReadableCounterexample, HasAtMostThreeDigitsANumber) {
  const auto& [expected, precision] = GetParam();
  const Case one =
      shrunk(expected.subject, expected.property, family(expected.topic, expected.family), precision);
  EXPECT_LE(most_digits(one), 3U) << write_case(one);
}

INSTANTIATE_TEST_SUITE_P(
    Shrink, ReadableCounterexample,
    testing::Combine(testing::Values(Expected{"sphere/printed_2ac", "robust-residual", "sphere", "random"},
                                     Expected{"sphere/printed_half_b", "robust-residual", "sphere", "random"},
                                     Expected{"sphere/textbook", "robust-verdict", "sphere", "far"},
                                     Expected{"sphere/half_b", "robust-verdict", "sphere", "far"},
                                     Expected{"quadratic/textbook", "robust-residual", "quadratic",
                                              "cancelling"}),
                     testing::Values(Precision::float32, Precision::float64)));

TEST(Shrink, NeverReturnsACaseThatDoesNotBreak) {
  for (const Family& from : families()) {
    const Case start = from.generate(5, Precision::float64);
    const double wanted = *numbers_of(const_cast<Case&>(start)).front().value;
    // Only cases that keep their first number break: the shrinker must leave that one alone.
    const auto breaks = [&](const Case& one) {
      Case copy = one;
      return *numbers_of(copy).front().value == wanted;
    };
    Case small = shrink(start, breaks);
    EXPECT_TRUE(breaks(small)) << from.name;
    EXPECT_LE(complexity(small), complexity(start));
  }
}

TEST(Shrink, LeavesOutEverythingThatDoesNotMatter) {
  const Case start = family("sphere", "transformed").generate(3, Precision::float32);
  const Case small = shrink(start, [](const Case&) { return true; });
  EXPECT_FALSE(std::get<RayQuestion>(small.question).transform.has_value());
  EXPECT_LE(most_digits(small), 1U);
}

TEST(Shrink, KeepsToItsBudget) {
  unsigned tries = 0;
  const auto breaks = [&](const Case&) {
    ++tries;
    return tries % 2 == 0;
  };
  (void)shrink(family("sphere", "random").generate(1, Precision::float64), breaks, {.tries = 100});
  EXPECT_LE(tries, 100U);
}

TEST(Simplicity, CountsSignificantDigitsAtThePrecision) {
  EXPECT_EQ(significant_digits(0, Precision::float64), 0U);
  EXPECT_EQ(significant_digits(1e6, Precision::float64), 1U);
  EXPECT_EQ(significant_digits(-0.125, Precision::float64), 3U);
  EXPECT_EQ(significant_digits(0.1F, Precision::float32), 1U);
  EXPECT_GT(significant_digits(0.1F, Precision::float64), 10U);
}

}  // namespace
}  // namespace rayproof
