#include "subjects/program/reply.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "case/reader.hpp"

namespace rayproof::program {
namespace {

const Case& a_ray() {
  static const Case one = read_case(
      R"({"ray": {"origin": [0,0,-5], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})");
  return one;
}
const Case& an_equation() {
  static const Case one = read_case(R"({"query": "quadratic", "a": 1, "b": -3, "c": 2})");
  return one;
}
const Case& a_point() {
  static const Case one =
      read_case(R"({"query": "point_in_polygon", "point": [0,0], "vertices": [[-1,-1],[1,-1],[0,1]]})");
  return one;
}

Outcome outcome_of(const char* line, const Case& one = a_ray()) { return ReplyLine(line).outcome(one); }

RayAnswer hits_of(const char* line) {
  const Outcome outcome = outcome_of(line);
  EXPECT_TRUE(outcome.is_answered()) << outcome.sentence;
  return std::get<RayAnswer>(outcome.answer);
}

TEST(Reply, HoldsWhatItSaysAndNoMore) {
  const RayAnswer answer = hits_of(R"({"id": 7, "verdict": "hit", "hits": [{"t": 4}, {"t": "0x1.8p+2"}]})");
  ASSERT_EQ(answer.hits.count, 2U);
  EXPECT_EQ(answer.hits.t[1], 6);
  EXPECT_FALSE(answer.says_contact);
  EXPECT_FALSE(answer.point || answer.normal || answer.barycentric);
}

TEST(Reply, AHitWithoutHitsIsAVerdictAlone) {
  const RayAnswer answer = hits_of(R"({"id": 7, "verdict": "hit"})");
  EXPECT_TRUE(answer.verdict_only);
  EXPECT_EQ(answer.hits.count, 1U);
  EXPECT_TRUE(std::isnan(answer.hits.t[0]));
  EXPECT_EQ(hits_of(R"({"id": 7, "verdict": "miss"})").hits.count, 0U);
}

TEST(Reply, KeepsContactPointNormalAndCoordinates) {
  const RayAnswer answer = hits_of(
      R"({"id": 7, "verdict": "hit", "hits": [{"t": 4}], "contact": "edge", "point": [1,2,3], "normal": [0,0,-1], "barycentric": [1,0,0]})");
  EXPECT_TRUE(answer.says_contact);
  EXPECT_EQ(answer.contact, Contact::edge);
  EXPECT_EQ(answer.point, glm::dvec3(1, 2, 3));
  EXPECT_EQ(answer.normal, glm::dvec3(0, 0, -1));
  EXPECT_EQ(answer.barycentric, glm::dvec3(1, 0, 0));
}

TEST(Reply, AContradictionOrAWrongTypeIsNonsense) {
  for (const char* line :
       {R"({"id": 7, "verdict": "hit", "hits": []})", R"({"id": 7, "verdict": "miss", "hits": [{"t": 1}]})",
        R"({"id": 7, "hits": [{"t": 1}]})", R"({"id": 7, "verdict": "perhaps"})",
        R"({"id": 7, "verdict": "hit", "hits": 4})", R"({"id": 7, "verdict": "hit", "hits": [{"x": 4}]})",
        R"({"id": 7, "verdict": "hit", "hits": [{"t": "nan"}]})",
        R"({"id": 7, "verdict": "hit", "hits": [{"t": null}]})",
        R"({"id": 7, "verdict": "hit", "hits": [{"t": 1}], "point": [1, 2]})",
        R"({"id": 7, "verdict": "hit", "hits": [1, 2, 3, 4, 5]})"}) {
    const Outcome outcome = outcome_of(line);
    EXPECT_EQ(outcome.kind, OutcomeKind::nonsense) << line;
    EXPECT_NE(outcome.sentence.find(line), std::string::npos) << outcome.sentence;
  }
}

TEST(Reply, MayDeclineOrGiveUp) {
  EXPECT_EQ(outcome_of(R"({"id": 7, "unsupported": true})").kind, OutcomeKind::unsupported);
  const Outcome refused = outcome_of(R"({"id": 7, "error": "too far"})");
  EXPECT_EQ(refused.kind, OutcomeKind::refused);
  EXPECT_EQ(refused.sentence, "gave up: too far");
  EXPECT_EQ(outcome_of(R"({"id": 7, "error": "\u001b[31mtrop loin, é"})").sentence,
            "gave up: ?[31mtrop loin, é");
}

TEST(Reply, RootsMayBeGivenInPart) {
  const auto roots = [](const char* line) {
    return std::get<QuadraticAnswer<double>>(outcome_of(line, an_equation()).answer);
  };
  EXPECT_EQ(roots(R"({"id": 1, "kind": "two", "x": [1, 2]})").roots[1], 2);
  EXPECT_EQ(roots(R"({"id": 1, "x": [1, 2]})").kind, RootKind::two);
  EXPECT_EQ(roots(R"({"id": 1, "x": []})").kind, RootKind::none);
  EXPECT_EQ(roots(R"({"id": 1, "x": [1]})").kind, RootKind::twice);
  const auto bare = roots(R"({"id": 1, "kind": "two"})");
  EXPECT_EQ(bare.count, 2U);
  EXPECT_TRUE(std::isnan(bare.roots[0]));
}

TEST(Reply, ANormalThatIsNoNumberIsLookedAtWhereThereIsOneAlone) {
  const auto answered = [](const char* radius) {
    const Case one = read_case(
        std::string(
            R"({"ray": {"origin": [0,0,-5], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": )") +
        radius + "}}");
    return outcome_of(R"({"id": 1, "verdict": "hit", "hits": [{"t": 5}], "normal": ["nan", "nan", "nan"]})",
                      one);
  };
  EXPECT_TRUE(answered("0").is_answered());
  EXPECT_EQ(answered("1").kind, OutcomeKind::nonsense);
}

TEST(Reply, APositionIsOneOfThree) {
  EXPECT_EQ(std::get<Position>(outcome_of(R"({"id": 1, "position": "boundary"})", a_point()).answer),
            Position::boundary);
  EXPECT_EQ(outcome_of(R"({"id": 1, "position": "between"})", a_point()).kind, OutcomeKind::nonsense);
  EXPECT_EQ(outcome_of(R"({"id": 1, "verdict": "hit"})", a_point()).kind, OutcomeKind::nonsense);
}

TEST(Reply, AnIdIsAWholeNumber) {
  EXPECT_EQ(ReplyLine(R"({"id": 12, "verdict": "miss"})").id(), 12U);
  for (const char* line : {R"({"verdict": "miss"})", R"({"id": "12"})", R"({"id": -1})", R"({"id": 1.5})"})
    EXPECT_FALSE(ReplyLine(line).id()) << line;
}

TEST(Reply, WhatIsNoObjectIsRefused) {
  for (const char* line : {"", "hello", "[1]", "{", R"({"id": 7, "verdict": NaN})"})
    EXPECT_THROW(ReplyLine reply(line), Refusal) << line;
}

TEST(Reply, AnExcerptIsShortAndPlain) {
  EXPECT_EQ(excerpt("a\tb\xff"), "a?b?");
  EXPECT_LT(excerpt(std::string(1000, 'x')).size(), 200U);
}

}  // namespace
}  // namespace rayproof::program
