#include "subjects/subject.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace rayproof {
namespace {

Case head_on(Precision precision) {
  return {.precision = precision,
          .question = RayQuestion{.ray = {{0, 0, -5}, {0, 0, 1}}, .shape = Sphere<double>{{0, 0, 0}, 1}}};
}

TEST(Subjects, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const Subject& subject : subjects())
    EXPECT_TRUE(names.insert(subject.full_name()).second) << subject.full_name();
}

TEST(Subjects, AreFoundByTheirNameAndNoOther) {
  for (const Subject& subject : subjects()) EXPECT_EQ(find_subject(subject.full_name()), &subject);
  EXPECT_EQ(find_subject("sphere/no_such_method"), nullptr);
  EXPECT_EQ(find_subject(""), nullptr);
}

TEST(Subjects, PromiseNoLessThanWasMeasured) {
  for (const Subject& subject : subjects()) {
    SCOPED_TRACE(subject.full_name());
    // A bound that is declared broken stands there to be exceeded.
    const auto is_claimed = [&](Claim claim) {
      return std::ranges::none_of(subject.contract.refuted, [&](const Refutation& one) {
        return !one.because.empty() && one.claim == claim;
      });
    };
    const auto expect_kept = [&](Claim claim, const Bound& bound) {
      if (is_claimed(claim) && std::isfinite(bound.measured)) {
        EXPECT_LE(bound.measured, bound.promised);
      }
    };
    expect_kept(Claim::verdict, subject.contract.verdict);
    expect_kept(Claim::residual, subject.contract.residual);
    expect_kept(Claim::ulp, subject.contract.ulp);
    expect_kept(Claim::point, subject.contract.hit.point);
    expect_kept(Claim::normal, subject.contract.hit.normal);
    expect_kept(Claim::coordinates, subject.contract.hit.coordinates);
  }
}

TEST(Subjects, SayWhyTheyBreakWhatTheyAreKnownToBreakAndClaimNothingOfIt) {
  for (const Subject& subject : subjects()) {
    SCOPED_TRACE(subject.full_name());
    bool is_refuted = false;
    for (const Refutation& refutation : subject.contract.refuted) {
      if (refutation.because.empty()) continue;
      is_refuted = true;
      EXPECT_FALSE(subject.contract.holds.contains(refutation.claim));
    }
    EXPECT_EQ(is_refuted, subject.contract.standing != Standing::sound);
  }
}

TEST(Subjects, MeetTheUnitSphereHeadOn) {
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    for (const Subject& subject : subjects()) {
      if (subject.topic != "sphere" || subject.name == "printed_2ac")
        continue;  // 2ac is wrong where c is not 1
      SCOPED_TRACE(subject.full_name());
      const auto answer = std::get<RayAnswer>(subject.answer(head_on(precision)));
      ASSERT_EQ(answer.hits.count, answer.nearest_only ? 1U : 2U);
      EXPECT_EQ(answer.hits.t[0], 4);
    }
  }
}

TEST(Subjects, AnswerInTheCasesPrecision) {
  Case one = head_on(Precision::float32);
  std::get<RayQuestion>(one.question).ray.direction = {0, 0, 3};
  const auto third = std::get<RayAnswer>(find_subject("sphere/centred")->answer(one)).hits.t[0];
  EXPECT_EQ(third, static_cast<double>(static_cast<float>(third)));
  EXPECT_NEAR(third, 4.0 / 3, 1e-6);
}

TEST(Subjects, TakeTheRayToTheObjectsSpaceAndTheNormalBack) {
  Case one = head_on(Precision::float64);
  auto& question = std::get<RayQuestion>(one.question);
  question.transform = glm::dmat4(1);
  (*question.transform)[2][2] = -2;  // mirrored, and twice as long along z
  for (const Subject& subject : subjects()) {
    if (subject.topic != "sphere" || subject.contract.standing == Standing::printed) continue;
    SCOPED_TRACE(subject.full_name());
    const auto answer = std::get<RayAnswer>(subject.answer(one));
    ASSERT_GE(answer.hits.count, 1U);
    EXPECT_EQ(answer.hits.t[0], 3);
    if (answer.normal) {
      EXPECT_EQ(*answer.normal, glm::dvec3(0, 0, -1));
    }
  }
}

}  // namespace
}  // namespace rayproof
