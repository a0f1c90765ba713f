#include <gtest/gtest.h>

#include <set>

#include "case/reader.hpp"
#include "case/writer.hpp"
#include "generators/generators.hpp"
#include "properties/engine/labels.hpp"

namespace rayproof {
namespace {

constexpr Precision both[] = {Precision::float32, Precision::float64};

TEST(Families, EachProducesWhatItIsFor) {
  for (const Family& family : families())
    for (const Precision precision : both)
      for (const std::string& missed : count_labels(family, precision, 1, label_sample).missed())
        ADD_FAILURE() << missed;
}

TEST(Families, ASmallSampleJudgesNoShareAndAWholeOneDoes) {
  const Family never{"never", "no tangent at all", nullptr, {{"tangent", 0.5}}};
  EXPECT_TRUE((LabelCount{&never, Precision::float32, label_sample - 1}.missed().empty()));
  EXPECT_EQ((LabelCount{&never, Precision::float32, label_sample}.missed().size()), 1U);
}

TEST(Families, AShareThatChanceMakesSmallerIsNotMissed) {
  const Family family{"seldom", "a rim now and then", nullptr, {{"rim", 0.1}}};
  const auto missed = [&](unsigned rims) {
    return LabelCount{&family, Precision::float32, 4000, {{"rim", rims}}}.missed().size();
  };
  EXPECT_EQ(missed(400), 0U);
  EXPECT_EQ(missed(325), 0U) << "the standard deviation is 19 cases";
  EXPECT_EQ(missed(323), 1U);
}

TEST(Families, WhatAlwaysHoldsIsMissedByOneCase) {
  const Family family{"all", "in reach without exception", nullptr, {{"in reach", 1}}};
  EXPECT_EQ((LabelCount{&family, Precision::float32, 4000, {{"in reach", 3999}}}.missed().size()), 1U);
}

TEST(Families, TheSameSeedGivesTheSameCase) {
  for (const Family& family : families())
    for (std::uint64_t seed = 0; seed < 20; ++seed)
      EXPECT_EQ(write_case(family.generate(seed, Precision::float32)),
                write_case(family.generate(seed, Precision::float32)));
}

TEST(Families, EveryCaseIsValidAndExactInItsPrecision) {
  for (const Family& family : families())
    for (const Precision precision : both)
      for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const Case one = family.generate(seed, precision);
        const std::string text = write_case(one);
        // Reading rounds to the precision: what comes back the same was exact.
        ASSERT_NO_THROW(EXPECT_EQ(write_case(read_case(text)), text)) << family.topic << '/' << family.name;
        EXPECT_EQ(topic_of(one), family.topic);
        EXPECT_EQ(one.precision, precision);
      }
}

TEST(Families, NoTwoOfATopicShareAName) {
  std::set<std::string> names;
  for (const Family& family : families())
    EXPECT_TRUE(names.insert(family.topic + "/" + family.name).second) << family.name;
}

TEST(Families, AnExactTangentIsATangent) {
  for (const Family& family : families())
    if (family.topic == "sphere" && family.name == "grazing") {
      EXPECT_GT(count_labels(family, Precision::float32, 3, 2000).share("tangent"), 0.1);
    }
}

}  // namespace
}  // namespace rayproof
