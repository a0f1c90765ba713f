#include "oracle/judged_answers.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rayproof::oracle {
namespace {

const Judgement some{.residual = 3};

RayAnswer hit_at(double t) {
  RayAnswer answer{.contact = Contact::crossing};
  answer.hits.push_back(t);
  return answer;
}

TEST(JudgedAnswers, NothingIsKnownBeforeItIsAdded) { EXPECT_EQ(JudgedAnswers().find(hit_at(1)), nullptr); }

TEST(JudgedAnswers, TheSameHitsHaveTheSameJudgementWhateverIsSaidOfTheFirstBesideT) {
  JudgedAnswers known;
  known.add(hit_at(1), some);
  RayAnswer same = hit_at(1);
  same.contact = Contact::edge;
  same.normal = {0, 0, 1};
  ASSERT_NE(known.find(same), nullptr);
  EXPECT_EQ(known.find(same)->residual, some.residual);
}

TEST(JudgedAnswers, AnotherTAnotherCountAndAnotherReachOfTheAnswerAreJudgedAnew) {
  JudgedAnswers known;
  known.add(hit_at(0), some);
  EXPECT_EQ(known.find(hit_at(-0.0)), nullptr);
  EXPECT_EQ(known.find(hit_at(std::nextafter(0.0, 1.0))), nullptr);
  EXPECT_EQ(known.find(RayAnswer{}), nullptr);
  RayAnswer other = hit_at(0);
  other.nearest_only = true;
  EXPECT_EQ(known.find(other), nullptr);
  other = hit_at(0);
  other.verdict_only = true;
  EXPECT_EQ(known.find(other), nullptr);
}

TEST(JudgedAnswers, NanIsTheSameAsItself) {
  JudgedAnswers known;
  known.add(hit_at(std::nan("")), some);
  EXPECT_NE(known.find(hit_at(std::nan(""))), nullptr);
}

TEST(JudgedAnswers, RootsAndPositionsAreNotMixedUp) {
  JudgedAnswers known;
  known.add(QuadraticAnswer<double>{RootKind::two, 2, {1, 2}}, some);
  known.add(Position::inside, some);
  EXPECT_NE(known.find(QuadraticAnswer<double>{RootKind::two, 2, {1, 2}}), nullptr);
  EXPECT_EQ(known.find(QuadraticAnswer<double>{RootKind::two, 2, {1, 3}}), nullptr);
  EXPECT_EQ(known.find(QuadraticAnswer<double>{RootKind::twice, 1, {1}}), nullptr);
  EXPECT_NE(known.find(Position::inside), nullptr);
  EXPECT_EQ(known.find(Position::boundary), nullptr);
}

TEST(JudgedAnswers, AreWhatTheOracleSays) {
  Case one;
  one.question = RayQuestion{{{0, 0, -5}, {0, 0, 1}}, Sphere<double>{{0, 0, 0}, 1}};
  JudgedAnswers known;
  for (const double t : {4.0, 4.5, 4.0}) {
    RayAnswer claimed = hit_at(t);
    claimed.nearest_only = true;
    EXPECT_EQ(known.judge(one, claimed).residual, judge(one, claimed).residual);
  }
}

}  // namespace
}  // namespace rayproof::oracle
