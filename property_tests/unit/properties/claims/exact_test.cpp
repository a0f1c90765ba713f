#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "case/reader.hpp"
#include "generators/generators.hpp"
#include "properties/property.hpp"
#include "unit/properties/broken_subjects.hpp"

namespace rayproof {
namespace {

constexpr const char* on_an_edge =
    R"({"ray": {"origin": [1,0,-2], "direction": [0,0,1]}, "shape": {"type": "triangle", "a": [0,0,0], "b": [4,0,0], "c": [0,4,0]}})";
constexpr const char* tangent =
    R"({"ray": {"origin": [1,0,-2], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})";
constexpr const char* from_the_surface =
    R"({"ray": {"origin": [0,0,-1], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})";
constexpr const char* rounded_case =
    R"({"ray": {"origin": [0.1,0.2,-2.3], "direction": [0.3,0.1,1.7]}, "shape": {"type": "sphere", "center": [0,0,0.1], "radius": 1.3}})";

/// What the property says of a subject that answers by `answer` and rounds nothing, or of one whose steps
/// nobody knows.
Ruling rule(const char* property, const char* text, Answer (*answer)(const Case&)) {
  const Case one = read_case(text);
  Subject subject = broken::subject(topic_of(one), answer);
  if (std::string(property) == "exact") subject.is_exact_on = [](const Case&) { return true; };
  Trial trial(subject, one);
  return find_property(property)->rule(trial);
}

Answer changed(const Case& one, void (*change)(RayAnswer&)) {
  auto answer = std::get<RayAnswer>(oracle::answer(one));
  change(answer);
  return answer;
}
Answer miss(const Case& /*one*/) { return RayAnswer{}; }
Answer crossing(const Case& one) {
  return changed(one, [](RayAnswer& answer) { answer.contact = Contact::crossing; });
}
Answer tangent_everywhere(const Case& one) {
  return changed(one, [](RayAnswer& answer) { answer.contact = Contact::tangent; });
}
Answer later_by_an_ulp(const Case& one) {
  return broken::changed_hits(one, [](double t) { return std::nextafter(t, infinity<double>); });
}
Answer second_hit_alone(const Case& one) {
  return changed(one, [](RayAnswer& answer) {
    answer.nearest_only = true;
    answer.hits.t[0] = answer.hits.t[answer.hits.count - 1];
    answer.hits.count = 1;
  });
}

TEST(Exact, TheOracleItselfIsExactlyRight) {
  for (const char* text : {on_an_edge, tangent, from_the_surface})
    for (const char* property : {"exact", "boundary"})
      EXPECT_EQ(rule(property, text, broken::exactly), Ruling::held) << text;
}

TEST(Exact, AWrongVerdictOnTheBoundaryIsExcusedByNoBand) {
  for (const char* text : {on_an_edge, tangent, from_the_surface})
    for (const char* property : {"exact", "boundary"})
      EXPECT_EQ(rule(property, text, miss), Ruling::broken) << text;
}

TEST(Exact, AnUlpIsOneTooMany) {
  EXPECT_EQ(rule("exact", from_the_surface, later_by_an_ulp), Ruling::broken);
  EXPECT_EQ(rule("boundary", from_the_surface, later_by_an_ulp), Ruling::held);
}

TEST(Exact, CrossingIsTrueOfAnEdgeAndNotOfATangent) {
  EXPECT_EQ(rule("exact", on_an_edge, crossing), Ruling::held);
  EXPECT_EQ(rule("exact", tangent, crossing), Ruling::broken);
}

TEST(Exact, TangentIsNotTrueOfACrossing) {
  EXPECT_EQ(rule("exact", from_the_surface, tangent_everywhere), Ruling::broken);
}

TEST(Exact, ANearestHitThatIsLeftOutIsABoundaryFinding) {
  EXPECT_EQ(rule("boundary", from_the_surface, second_hit_alone), Ruling::broken);
}

TEST(Exact, ACaseThatEveryMethodRoundsIsNoneOfTheBoundarysBusiness) {
  EXPECT_EQ(rule("boundary", rounded_case, miss), Ruling::outside);
}

TEST(Exact, AGrossErrorIsNoneOfTheBoundarysBusiness) {
  constexpr const char* through_the_middle =
      R"({"ray": {"origin": [0,0,-2], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})";
  EXPECT_EQ(rule("boundary", through_the_middle, miss), Ruling::outside);
}

/// The share of a family's cases on which the subject rounds nothing.
double exact_share(const Subject& subject, const Family& family, Precision precision) {
  constexpr unsigned cases = 1000;
  unsigned exact = 0;
  for (unsigned k = 0; k < cases; ++k)
    exact += subject.is_exact_on(family.generate(combine(11, k), precision)) ? 1 : 0;
  return exact / double{cases};
}

TEST(TheFamiliesWhole, AreDecidedWithoutARoundingByEveryPlainMethodAThirdOfTheTime) {
  int judged = 0;
  for (const Family& family : families()) {
    if (family.name != "whole") continue;
    for (const Subject& subject : subjects()) {
      if (subject.topic != family.topic || subject.is_exact_on == nullptr) continue;
      if (!subject.contract.holds.contains(Claim::exact)) continue;
      for (const Precision precision : {Precision::float32, Precision::float64})
        EXPECT_GE(exact_share(subject, family, precision), 0.33)
            << subject.full_name() << ' ' << name_of(precision);
      ++judged;
    }
  }
  EXPECT_GE(judged, 22);
}

TEST(TheFamiliesWhole, AreThereForEveryTopic) {
  for (const std::string& topic : topics())
    EXPECT_TRUE(std::ranges::any_of(families(), [&](const Family& family) {
      return family.topic == topic && family.name == "whole";
    })) << topic;
}

}  // namespace
}  // namespace rayproof
