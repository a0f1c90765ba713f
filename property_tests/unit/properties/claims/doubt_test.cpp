#include <gtest/gtest.h>

#include "case/reader.hpp"
#include "generators/generators.hpp"
#include "unit/properties/broken_subjects.hpp"

namespace rayproof {
namespace {

Ruling rule(const Case& one, bool (*is_in_doubt)(const Case&)) {
  Subject subject = broken::subject(topic_of(one), broken::exactly);
  subject.is_in_doubt = is_in_doubt;
  Trial trial(subject, one);
  return find_property("sure")->rule(trial);
}
Ruling rule(const std::string& text, bool (*is_in_doubt)(const Case&)) {
  return rule(read_case(text), is_in_doubt);
}
bool always(const Case& /*any*/) { return true; }
bool never(const Case& /*any*/) { return false; }

/// Of a hundred random rays of a topic, how many are ordinary.
int ordinary_of_hundred(const std::string& topic, Precision precision) {
  int ordinary = 0;
  for (const Family& family : families())
    if (family.topic == topic && family.name == "random")
      for (std::uint64_t seed = 0; seed < 100; ++seed)
        ordinary += rule(family.generate(seed, precision), always) == Ruling::broken ? 1 : 0;
  return ordinary;
}

TEST(SureProperty, OrdinaryRaysAreNotRareSoThatDoubtOfAllIsNoticed) {
  for (const char* topic : {"sphere", "plane", "triangle", "box", "parallelepiped"})
    for (const Precision precision : {Precision::float32, Precision::float64})
      EXPECT_GE(ordinary_of_hundred(topic, precision), 5) << topic;
}

TEST(SureProperty, NoDoubtNeedsNoOracleAndASubjectWithoutBoundsIsNotAsked) {
  const std::string head_on =
      R"({"precision": "float32", "ray": {"origin": [0.25,0.5,-5], "direction": [0,0,3]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})";
  EXPECT_EQ(rule(head_on, always), Ruling::broken);
  EXPECT_EQ(rule(head_on, never), Ruling::held);
  EXPECT_EQ(rule(head_on, nullptr), Ruling::outside);
}

TEST(SureProperty, DoubtIsFairBesideATangentAnEdgeAFaceTheOriginAndAMiddle) {
  const std::string ray = R"({"precision": "float32", "ray": {"origin": )",
                    box = R"(}, "shape": {"type": "box", "min": [0,0,0], "max": [1,1,1]}})",
                    sphere = R"(}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})",
                    plane = R"(}, "shape": {"type": "plane", "point": [0,0,0], "normal": [0,0,1]}})";
  EXPECT_EQ(rule(ray + R"([0.9999,0,-5], "direction": [0,0,3])" + sphere, always), Ruling::held) << "tangent";
  EXPECT_EQ(rule(ray + R"([0.5,0.5,-5], "direction": [0.1,0.1,1])" + box, always), Ruling::held) << "edge";
  EXPECT_EQ(rule(ray + R"([0.5,0.5,5], "direction": [1,0.1,0])" + plane, always), Ruling::held) << "face";
  EXPECT_EQ(rule(ray + R"([0.5,0.5,0], "direction": [0.1,0.1,1])" + plane, always), Ruling::held) << "origin";
  EXPECT_EQ(rule(ray + R"([0.5,0.5,16777217], "direction": [0.1,0.1,-16777216])" + plane, always),
            Ruling::held)
      << "numbers of no ordinary size";
  EXPECT_EQ(rule(ray + R"([0.5,0.5,4097], "direction": [0.1,0.1,-4096])" + plane, always), Ruling::broken);
}

TEST(SureProperty, DoubtIsFairOfATriangleWithoutArea) {
  const std::string passing_by =
      R"({"precision": "float32", "ray": {"origin": [0,1,0], "direction": [0,0,1]}, "shape": {"type": "triangle", "a": [0,0,0], "b": [0,0,0], "c": )";
  EXPECT_EQ(rule(passing_by + "[1,0,0]}}", always), Ruling::held) << "two vertices in one point";
  EXPECT_EQ(rule(passing_by + "[0,0,0]}}", always), Ruling::held) << "three";
}

TEST(SureProperty, TheMiddleBelowAPowerOfTwoIsAQuarterOfAnUlpAway) {
  const std::string before =
      R"({"precision": "float64", "ray": {"origin": [20,0,0], "direction": [1,0,0]}, "shape": )";
  EXPECT_EQ(rule(before + R"({"type": "plane", "normal": [-1,0,0], "d": 4.000000000000001}})", always),
            Ruling::held);
  EXPECT_EQ(rule(before + R"({"type": "plane", "normal": [-1,0,0], "d": 4}})", always), Ruling::broken);
}

}  // namespace
}  // namespace rayproof
