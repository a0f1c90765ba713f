#include "properties/guests/guest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "case/reader.hpp"
#include "properties/engine/kind.hpp"
#include "properties/guests/probe.hpp"
#include "unit/properties/guests/stranger.hpp"

namespace rayproof {
namespace {

const Case& from_five_away() {
  static const Case one = read_case(
      R"({"ray": {"origin": [0.25,0,-5], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})");
  return one;
}

TEST(Guest, IsJudgedByWhatItSaysAlone) {
  for (Answer (*const answer)(const Case&) : {nearest_alone, verdict_alone}) {
    Subject one = guest("sphere", answer);
    (void)learn_abilities(one, 1, {Precision::float64}, never_stopped);
    Trial trial(one, from_five_away());
    EXPECT_FALSE(trial.judgement().wrong);
    for (const Property& property : properties())
      if (one.contract.holds.contains(property.claim)) {
        EXPECT_NE(ruling_of(property, trial), Ruling::broken) << property.name;
      }
  }
}

TEST(Guest, EqualHitsOfATangentAreOne) {
  Subject one = guest("sphere", nullptr);
  const Case grazed = read_case(
      R"({"ray": {"origin": [1,0,-5], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})");
  RayAnswer twice;
  twice.hits.push_back(5);
  twice.hits.push_back(5.000000000000001);
  EXPECT_EQ(std::get<RayAnswer>(completed(one, grazed, twice)).hits.count, 1U);
  twice.hits.t[1] = 5;  // as good as right: many a sound program has both roots of D = 0
  EXPECT_EQ(std::get<RayAnswer>(completed(one, grazed, twice)).hits.count, 1U);
  EXPECT_EQ(std::get<RayAnswer>(completed(one, from_five_away(), twice)).hits.count, 2U);
}

TEST(Guest, MayNotGiveOneCrossingTwice) {
  const auto count_of = [](const char* topic, const char* text, double t) {
    RayAnswer twice;
    twice.hits.push_back(t);
    twice.hits.push_back(t);
    return std::get<RayAnswer>(completed(guest(topic, nullptr), read_case(text), twice)).hits.count;
  };
  const char* const from_centre =
      R"({"ray": {"origin": [0,0,0], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})";
  const char* const plane =
      R"({"ray": {"origin": [0,0,-1], "direction": [0,0,1]}, "shape": {"type": "plane", "normal": [0,0,1], "d": 0}})";
  const char* const through_an_edge =
      R"({"ray": {"origin": [0.5,-2,-2], "direction": [0,1,1], "t_max": 2.5}, "shape": {"type": "box", "min": [0,0,0], "max": [1,1,1]}})";
  EXPECT_EQ(count_of("sphere", from_centre, 1), 2U);
  EXPECT_EQ(count_of("plane", plane, 1), 2U);
  EXPECT_EQ(count_of("box", through_an_edge, 2), 1U) << "it is met in two faces";
}

TEST(Guest, MayMeanEitherFaceOfABoxWithoutThickness) {
  const auto with_normal = [](const Case& asked, double side) {
    auto answer = std::get<RayAnswer>(oracle::answer(asked));
    answer.normal = glm::dvec3(0, side, 0);
    return answer;
  };
  const Case flat = read_case(
      R"({"ray": {"origin": [0,1,0], "direction": [0,-1,0]}, "shape": {"type": "box", "min": [-1,0,-1], "max": [1,0,1]}})");
  const Case thick = read_case(
      R"({"ray": {"origin": [0,2,0], "direction": [0,-1,0]}, "shape": {"type": "box", "min": [-1,0,-1], "max": [1,1,1]}})");
  const Subject one = guest("box", nullptr);
  const auto is_broken = [&](const Case& asked, double side) {
    Trial trial(one, asked);
    trial.know({.answer = with_normal(asked, side)}, {});
    return std::ranges::any_of(properties(), [&](const Property& property) {
      return property.name == "normal" && ruling_of(property, trial) == Ruling::broken;
    });
  };
  EXPECT_FALSE(is_broken(flat, 1));
  EXPECT_FALSE(is_broken(flat, -1));
  EXPECT_FALSE(is_broken(thick, 1));
  EXPECT_TRUE(is_broken(thick, -1));
}

TEST(Guest, AHitAtARimMayFallBetweenSideAndCap) {
  Subject one = guest("cylinder", nullptr);
  const Case at_rim = read_case(
      R"({"ray": {"origin": [-2,0,-1], "direction": [1,0,1]}, "shape": {"type": "cylinder", "rx": 1, "ry": 1, "height": 1, "capped": true}})");
  RayAnswer behind;
  behind.hits.push_back(2);
  behind.point = {0, 0, 1};
  const auto with_rim = std::get<RayAnswer>(completed(one, at_rim, behind));
  EXPECT_EQ(with_rim.hits.count, 2U);
  EXPECT_FALSE(with_rim.point) << "it is of the second hit";
  const Case through_cap = read_case(
      R"({"ray": {"origin": [0.5,0,-1], "direction": [0,0,1]}, "shape": {"type": "cylinder", "rx": 1, "ry": 1, "height": 1, "capped": true}})");
  const auto as_given = std::get<RayAnswer>(completed(one, through_cap, behind));
  EXPECT_EQ(as_given.hits.count, 1U);
  EXPECT_TRUE(as_given.point);
}

TEST(Guest, RootsThatAreLeftOutAreNotJudged) {
  Subject one = guest("quadratic", nullptr);
  const Case equation = read_case(R"({"query": "quadratic", "a": 1, "b": -3, "c": 2})");
  const QuadraticAnswer<double> bare{RootKind::two, 2, {std::nan(""), std::nan("")}};
  EXPECT_FALSE(oracle::judge(equation, completed(one, equation, bare)).wrong);
  const QuadraticAnswer<double> other{RootKind::none};
  EXPECT_TRUE(oracle::judge(equation, completed(one, equation, other)).wrong);
}

TEST(Guest, IsAskedNothingBeyondItsDomain) {
  const Subject one = guest("sphere", nullptr);
  Case huge = from_five_away();
  EXPECT_TRUE(is_for_guest(one, huge));
  std::get<RayQuestion>(huge.question).ray.origin.x = 1e100;
  EXPECT_FALSE(is_for_guest(one, huge));
}

TEST(Guest, IsAskedNoSolidWhoseVolumeIsRounding) {
  const Subject one = guest("parallelepiped", nullptr);
  const auto with_height = [](const char* height) {
    return read_case(
        std::string(
            R"({"ray": {"origin": [0,0,-5], "direction": [0,0,1]}, "shape": {"type": "parallelepiped", "corner": [0,0,0], "edges": [[3,0,0],[0,1,0],[1,1,)") +
        height + "]]}}");
  };
  EXPECT_TRUE(is_for_guest(one, with_height("1e-12")));
  EXPECT_FALSE(is_for_guest(one, with_height("1e-15")));
}

FindingKind kind_with(const char* property, const Case& one, const Answer& got) {
  static const Subject somebody = guest("sphere", nullptr);
  Finding finding{.subject = &somebody, .property = find_property(property), .one = one};
  finding.evidence.got = got;
  finding.evidence.exact = oracle::answer(one);
  return kind_of(finding);
}

TEST(Kind, SaysHowBadAFindingIs) {
  EXPECT_EQ(kind_with("answers", from_five_away(), RayAnswer{}), FindingKind::protocol);
  EXPECT_EQ(kind_with("boundary", from_five_away(), RayAnswer{}), FindingKind::boundary);
  EXPECT_EQ(kind_with("verdict", from_five_away(), RayAnswer{}), FindingKind::gross);
  RayAnswer off = std::get<RayAnswer>(oracle::answer(from_five_away()));
  off.hits.t[0] += 1e-7;
  EXPECT_EQ(kind_with("residual", from_five_away(), off), FindingKind::rounding);
  off.hits.t[0] += 1;
  EXPECT_EQ(kind_with("residual", from_five_away(), off), FindingKind::gross);
  Case large = from_five_away();
  auto& asked = std::get<RayQuestion>(large.question);
  asked.ray.origin.z = -1e15;
  asked.shape = Sphere<double>{{0, 0, 0}, 1e14};
  EXPECT_EQ(kind_with("verdict", large, RayAnswer{}), FindingKind::range);
}

}  // namespace
}  // namespace rayproof
