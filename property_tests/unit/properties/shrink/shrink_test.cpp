#include "properties/shrink/shrink.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include "case/writer.hpp"
#include "generators/generators.hpp"
#include "properties/numbers.hpp"
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
  Precision precision = Precision::float32;
};

const char* format_of(const Expected& expected) { return name_of(expected.precision); }

void PrintTo(const Expected& expected, std::ostream* out) {
  *out << expected.subject << " breaks " << expected.property << " on " << expected.topic
       << " cases that are " << expected.family << ", in " << format_of(expected);
}

std::vector<Expected> in_both_precisions(std::vector<Expected> all) {
  const std::size_t count = all.size();
  for (std::size_t i = 0; i < count; ++i) {
    all.push_back(all[i]);
    all.back().precision = Precision::float64;
  }
  return all;
}

std::string test_name(const testing::TestParamInfo<Expected>& info) {
  std::string name = std::string(info.param.subject) + "_" + format_of(info.param);
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

class ReadableCounterexample : public testing::TestWithParam<Expected> {};

TEST_P(ReadableCounterexample, HasAtMostThreeDigitsANumber) {
  const Expected& expected = GetParam();
  const Case one = shrunk(expected.subject, expected.property, family(expected.topic, expected.family),
                          expected.precision);
  EXPECT_LE(most_digits(one), 3U) << write_case(one);
}

INSTANTIATE_TEST_SUITE_P(Shrink, ReadableCounterexample,
                         testing::ValuesIn(in_both_precisions(
                             {{"sphere/printed_2ac", "robust-residual", "sphere", "random"},
                              {"sphere/printed_half_b", "robust-residual", "sphere", "random"},
                              {"sphere/textbook", "robust-verdict", "sphere", "far"},
                              {"sphere/half_b", "robust-verdict", "sphere", "far"},
                              {"quadratic/textbook", "robust-residual", "quadratic", "cancelling"}})),
                         test_name);

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

// Several at a time once went on with moves for more vertices than the case had left.
TEST(Shrink, AskedSeveralAtOnceComesAsFarDown) {
  constexpr ShrinkBudget budget{.tries = 2000};
  const auto some_break = [](std::span<const Case> cases) {
    EXPECT_LE(cases.size(), 16U);
    return std::optional(cases.size() / 2);
  };
  for (const Family& from : families()) {
    if (std::string_view(from.name) != "random") continue;  // one of each topic
    const Case start = from.generate(5, Precision::float64);
    const Case small = shrink(start, Breaking{.first = some_break, .at_once = 16}, budget);
    const Case alone = shrink(
        start, [](const Case&) { return true; }, budget);
    EXPECT_TRUE(is_valid(small)) << from.name;
    EXPECT_LE(complexity(small), 2 * complexity(alone)) << from.name;
  }
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
