#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "case/reader.hpp"
#include "properties/numbers.hpp"
#include "unit/properties/broken_subjects.hpp"

namespace rayproof {
namespace {

const Case& head_on() {
  static const Case one = read_case(
      R"({"precision": "float32", "ray": {"origin": [0.25,0,-5], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})");
  return one;
}

Ruling rule(const char* property, Answer (*answer)(const Case&), const Case& one = head_on()) {
  const Subject subject = broken::subject(topic_of(one), answer);
  Trial trial(subject, one);
  return find_property(property)->rule(trial);
}

float after(double t) { return std::nextafter(static_cast<float>(t), HUGE_VALF); }

TEST(Properties, AllHoldForTheOracleItself) {
  for (const Property& property : properties()) {
    // The oracle refuses NaN and has no running-error arithmetic; why a ray misses is asked of misses alone,
    // coordinates of triangles.
    if (property.claim == Claim::nan || property.claim == Claim::bounded) continue;
    if (property.claim == Claim::contact || property.claim == Claim::coordinates) continue;
    if (property.claim == Claim::exact) continue;  // every plain method rounds on this case
    if (property.name == "digits") continue;       // it speaks of guests alone
    EXPECT_EQ(rule(property.name.data(), broken::exactly), Ruling::held) << property.name;
  }
}

TEST(Properties, AMissForAnotherReasonIsAWrongContact) {
  const Case in_plane = read_case(
      R"({"ray": {"origin": [0,0,0], "direction": [1,0,0]}, "shape": {"type": "plane", "normal": [0,0,1], "d": 0}})");
  const auto parallel = [](const Case&) -> Answer { return RayAnswer{.contact = Contact::parallel}; };
  EXPECT_EQ(rule("contact", parallel, in_plane), Ruling::broken);
  EXPECT_EQ(rule("contact", broken::exactly, in_plane), Ruling::held);
  EXPECT_EQ(rule("contact", broken::exactly), Ruling::outside);
}

TEST(Properties, EachClaimHasAProperty) {
  for (std::size_t c = 0; c < claim_count; ++c) {
    bool found = false;
    for (const Property& property : properties()) found |= property.claim == static_cast<Claim>(c);
    EXPECT_TRUE(found) << c;
  }
}

TEST(Properties, AMissIsAWrongVerdict) {
  const auto miss = [](const Case&) -> Answer { return RayAnswer{}; };
  EXPECT_EQ(rule("verdict", miss), Ruling::broken);
  EXPECT_EQ(rule("robust-verdict", miss), Ruling::broken);
}

TEST(Properties, ALineThatMeetsTheShapeAndIsMissedIsNotConservativeWhateverTheInterval) {
  const auto miss = [](const Case&) -> Answer { return RayAnswer{}; };
  Case behind = head_on(), beside = head_on();
  std::get<RayQuestion>(behind.question).ray.origin.z = 5;
  std::get<RayQuestion>(beside.question).ray.origin.x = 3;
  EXPECT_EQ(rule("conservative", miss), Ruling::broken);
  EXPECT_EQ(rule("conservative", miss, behind), Ruling::broken);
  EXPECT_EQ(rule("conservative", broken::exactly, behind), Ruling::held);
  EXPECT_EQ(rule("conservative", miss, beside), Ruling::outside);
}

TEST(Properties, AHitThatIsNotThereIsAWrongVerdict) {
  Case beside = head_on();
  std::get<RayQuestion>(beside.question).ray.origin.x = 3;
  const auto invented = [](const Case&) -> Answer {
    RayAnswer answer;
    answer.hits.push_back(5);
    return answer;
  };
  EXPECT_EQ(rule("verdict", invented, beside), Ruling::broken);
}

TEST(Properties, AFlippedSignBreaksResidualAndUlp) {
  const auto flipped = [](const Case& one) { return broken::changed_hits(one, [](double t) { return -t; }); };
  EXPECT_EQ(rule("residual", flipped), Ruling::broken);
  EXPECT_EQ(rule("ulp", flipped), Ruling::broken);
  EXPECT_EQ(rule("robust-residual", flipped), Ruling::broken);
  EXPECT_EQ(rule("ascending", flipped), Ruling::broken);
}

TEST(Properties, TwoUlpsOffBreakAnUlpContractOfOneButNotTheRobustBound) {
  const auto off = [](const Case& one) {
    return broken::changed_hits(one, [](double t) { return after(after(t)); });
  };
  EXPECT_EQ(rule("ulp", off), Ruling::broken);
  EXPECT_EQ(rule("robust-residual", off), Ruling::held);
}

TEST(Properties, TheNextFloatIsNotCorrectlyRounded) {
  const auto next = [](const Case& one) {
    return broken::changed_hits(one, [](double t) { return after(t); });
  };
  EXPECT_EQ(rule("rounded", next), Ruling::broken);
  EXPECT_EQ(rule("rounded", [](const Case&) -> Answer { return RayAnswer{}; }), Ruling::broken);
}

TEST(Properties, OnlyWhoTakesTheTransformCanRoundOnceUnderIt) {
  Case moved = head_on();
  std::get<RayQuestion>(moved.question).transform = glm::dmat4(3);
  (*std::get<RayQuestion>(moved.question).transform)[3][3] = 1;
  Subject subject = broken::subject("sphere", broken::exactly);
  EXPECT_EQ(find_property("rounded")->rule(*std::make_unique<Trial>(subject, moved)), Ruling::outside);
  subject.takes_transforms = true;
  EXPECT_EQ(find_property("rounded")->rule(*std::make_unique<Trial>(subject, moved)), Ruling::held);
}

TEST(Properties, DescendingHitsAndNaNHitsAreNoticed) {
  const auto descending = [](const Case& one) -> Answer {
    auto answer = std::get<RayAnswer>(oracle::answer(one));
    std::swap(answer.hits.t[0], answer.hits.t[1]);
    return answer;
  };
  const auto nan = [](const Case& one) {
    return broken::changed_hits(one, [](double) { return std::numeric_limits<double>::quiet_NaN(); });
  };
  EXPECT_EQ(rule("ascending", descending), Ruling::broken);
  EXPECT_EQ(rule("ascending", nan), Ruling::broken);
}

Answer nearest_hit_twice(const Case& one) {
  auto answer = std::get<RayAnswer>(oracle::answer(one));
  answer.hits.t[1] = answer.hits.t[0];
  return answer;
}

TEST(Properties, OneHitGivenForTwoIsNoticed) {
  EXPECT_EQ(rule("ascending", nearest_hit_twice), Ruling::broken);
}

TEST(Properties, TwoHitsThatATransformMayMergeAreNotTakenForOneGivenTwice) {
  Case moved = head_on();
  std::get<RayQuestion>(moved.question).transform = glm::dmat4(1);
  const Subject subject = broken::subject("sphere", nearest_hit_twice);
  EXPECT_EQ(find_property("ascending")->rule(*std::make_unique<Trial>(subject, moved)), Ruling::held);
}

TEST(Properties, AHitOutsideTheIntervalIsNoticed) {
  Case cut = head_on();
  std::get<RayQuestion>(cut.question).ray.t_max = 4.5;
  const auto whole_line = [](const Case& one) {
    Case uncut = one;
    std::get<RayQuestion>(uncut.question).ray.t_max = infinity<double>;
    return oracle::answer(uncut);
  };
  EXPECT_EQ(rule("ascending", whole_line, cut), Ruling::broken);
}

TEST(Properties, AnAbsoluteToleranceIsNotScaleFree) {
  const auto tolerant = [](const Case& one) {
    return broken::changed_hits(one, [](double t) { return t + 0.25; });
  };
  EXPECT_EQ(rule("scaled", tolerant), Ruling::broken);
}

TEST(Properties, ABiasAlongTheRayIsNotMirrored) {
  const auto late = [](const Case& one) {
    return broken::changed_hits(one, [](double t) { return after(t); });
  };
  EXPECT_EQ(rule("reversed", late), Ruling::broken);
}

TEST(Properties, ATransformThatIsIgnoredIsNoticed) {
  const auto deaf = [](const Case& one) {
    Case still = one;
    std::get<RayQuestion>(still.question).transform.reset();
    return oracle::answer(still);
  };
  EXPECT_EQ(rule("moved", deaf), Ruling::broken);
}

TEST(Properties, ABatchThatDiffersInTheLastBitIsNoticed) {
  Subject subject = broken::subject("sphere", broken::exactly);
  subject.answer_in_batch = [](const Case& one) {
    return broken::changed_hits(one, [](double t) { return after(t); });
  };
  Trial trial(subject, head_on());
  EXPECT_EQ(find_property("batch")->rule(trial), Ruling::broken);
}

TEST(Properties, AHitFromNaNIsNoticedAndAMissIsNot) {
  const auto always = [](const Case&) -> Answer {
    RayAnswer answer;
    answer.hits.push_back(1);
    return answer;
  };
  const auto never = [](const Case&) -> Answer { return RayAnswer{}; };
  EXPECT_EQ(rule("nan", always), Ruling::broken);
  EXPECT_EQ(rule("nan", never), Ruling::held);
}

TEST(Properties, NaNIsPutInSomeNumbersOfAnEndlessOutlineInXYAndZ) {
  static std::array<unsigned, 3> spoilt{};
  static unsigned asked = 0;
  Case one = head_on();
  std::get<RayQuestion>(one.question).shape = Polygon<double>{std::vector<glm::dvec3>(20'000)};
  const auto never = [](const Case& given) -> Answer {
    const auto& shape = std::get<RayQuestion>(given.question).shape;
    ++asked;
    for (const glm::dvec3& vertex : std::get<Polygon<double>>(shape).vertices)
      for (int axis = 0; axis < 3; ++axis)
        spoilt[static_cast<std::size_t>(axis)] += std::isnan(vertex[axis]) ? 1 : 0;
    return RayAnswer{};
  };
  EXPECT_EQ(rule("nan", never, one), Ruling::held);
  EXPECT_LT(asked, 2000U);
  for (const unsigned count : spoilt) EXPECT_GT(count, 300U);
}

TEST(Properties, ABoundThatEnclosesNothingIsNoticed) {
  Subject subject = broken::subject("sphere", broken::exactly);
  const auto bounded = [&](auto hits) {
    subject.bounded_hits = hits;
    Trial trial(subject, head_on());
    return find_property("bounded")->rule(trial);
  };
  EXPECT_EQ(bounded([](const Case&) { return std::vector{std::pair{4.0, 1e-9}}; }), Ruling::broken);
  EXPECT_EQ(bounded([](const Case&) { return std::vector{std::pair{4.0, 0.1}}; }), Ruling::held);
  EXPECT_EQ(bounded([](const Case&) { return std::vector{std::pair{4.0, HUGE_VAL}}; }), Ruling::held);
}

TEST(Properties, WhatLiesOutsideTheDomainIsNotJudged) {
  Case huge = head_on();
  std::get<RayQuestion>(huge.question).ray.origin.z = -1e30;
  const auto miss = [](const Case&) -> Answer { return RayAnswer{}; };
  EXPECT_EQ(rule("verdict", miss, huge), Ruling::outside);
}

TEST(Numbers, AreAllThereInTheOrderOfTheFormat) {
  Case one = head_on();
  EXPECT_EQ(numbers_of(one).size(), 12U);
  std::get<RayQuestion>(one.question).transform = glm::dmat4(1);
  const auto all = numbers_of(one);
  ASSERT_EQ(all.size(), 24U);
  EXPECT_EQ(all.front().field, "ray.origin");
  for (std::size_t i = 12; i < 24; ++i) EXPECT_EQ(*all[i].value, all[i].plain);
}

}  // namespace
}  // namespace rayproof
