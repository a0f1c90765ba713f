#include <gtest/gtest.h>

#include <set>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/examination/examination.hpp"
#include "properties/diagnosis/models/outlines/near_sides.hpp"
#include "subjects/default_contract.hpp"
#include "unit/diagnosis/clinic.hpp"
#include "unit/diagnosis/faulty/faulty.hpp"

namespace rayproof::faulty {
namespace {

using Causes = std::set<std::string_view>;
using diagnosis::Answers;

/// The causes that are named where these properties are looked at in both precisions.
Causes causes_of(const Subject& subject,
                 std::initializer_list<const char*> properties = {"verdict", "residual", "ascending"}) {
  std::vector<Complaint> complaints;
  for (const Precision precision : {Precision::float32, Precision::float64})
    for (const char* const name : properties) {
      Complaint found = complaint(subject, *find_property(name), precision, 200);
      if (!found.failing.empty()) complaints.push_back(std::move(found));
    }
  std::vector<const Complaint*> pointers;
  for (const Complaint& one : complaints) pointers.push_back(&one);
  Causes causes;
  for (const std::vector<Diagnosis>& groups : diagnose_together(pointers))
    for (const Diagnosis& group : groups) causes.insert(group.cause ? group.cause->name : "none");
  return causes;
}

Causes causes_of(const char* topic, Answer (*code)(const Case&)) {
  return causes_of(subject_of(topic, code));
}

TEST(Cover, NamesOneCauseOfOneFaultInAllPropertiesAndPrecisions) {
  EXPECT_EQ(causes_of("triangle", answer<Fault::absolute_epsilon>), Causes{"slope-small-1e-2"});
  EXPECT_EQ(causes_of("sphere", answer<Fault::ignores_t_min>), Causes{"ignores-t-min"});
}

TEST(Cover, NamesTwoCausesOfTwoFaults) {
  EXPECT_EQ(causes_of("triangle", two_faults), (Causes{"culls-back-faces", "edge-b-not-tested"}));
}

/// The exact answer for the solid whose corner has the other sign.
Answer of_negated_corner(const Case& one) {
  Case other = one;
  auto& corner = std::get<Parallelepiped<double>>(std::get<RayQuestion>(other.question).shape).corner;
  corner = -corner;
  return oracle::answer(other);
}

TEST(Cover, ExplainsAWrongNormalByTheReadingThatExplainsTheHits) {
  EXPECT_EQ(causes_of(subject_of("parallelepiped", of_negated_corner), {"verdict", "normal", "point"}),
            Causes{"corner-negated"});
}

Answer always_misses(const Case& /*one*/) { return RayAnswer{}; }

TEST(Cover, SaysOfWhoFindsNothingThatAloneThoughManyAModelForeseesMisses) {
  EXPECT_EQ(causes_of("box", always_misses), Causes{"never-hits"});
  EXPECT_EQ(causes_of("triangle", always_misses), Causes{"never-hits"});
  EXPECT_EQ(causes_of("sphere", always_misses), Causes{"radius-square-added"});
}

/// It finds no hit with t below 1e-2, and none at 0.
Answer beyond_epsilon(const Case& one) {
  Answer answer = oracle::answer(one);
  auto& hits = std::get<RayAnswer>(answer).hits;
  if (hits.count > 0 && hits.t[0] < 1e-2) answer = RayAnswer{};
  return answer;
}

TEST(Cover, NamesAnEpsilonThoughTheBoundaryShowsNoMoreThanZero) {
  const Subject subject = subject_of("plane", beyond_epsilon);
  const auto complaint_of = [&](const char* property, double step) {
    Complaint made{.patient = patient_of(subject, *find_property(property))};
    for (int k = 1; k < 10; ++k)
      made.failing.push_back(
          {.precision = Precision::float64,
           .question = RayQuestion{.ray = {{k, 0, k * step}, {0, 0, -1}, 0, infinity<double>},
                                   .shape = ImplicitPlane{{0, 0, 1}, 0}}});
    return made;
  };
  const Complaint before = complaint_of("verdict", 0x1p-10), at_zero = complaint_of("boundary", 0);
  for (const auto& groups : diagnose_together(std::vector{&before, &at_zero})) {
    ASSERT_EQ(groups.size(), 1U) << in_words(groups);
    EXPECT_EQ(groups[0].cause, find_hypothesis("epsilon-1e-2")) << in_words(groups);
  }
}

/// Whether the line hits, and no more.
Answer whether_the_line_hits(const Case& one) {
  RayAnswer answer{.verdict_only = true};
  if (!numbers_in(oracle::answer(on_whole_line(one))).empty()) answer.hits.push_back(0);
  return answer;
}

TEST(Cover, NamesOneCauseOfWhoSaysOnlyWhether) {
  Subject subject = subject_of("sphere", whether_the_line_hits);
  subject.abilities.all_hits = subject.abilities.numbers = false;
  const Causes causes = causes_of(subject);
  EXPECT_EQ(causes.size(), 1U) << testing::PrintToString(causes);
  EXPECT_TRUE(causes.contains("whole-line") || causes.contains("ignores-t-min"))
      << testing::PrintToString(causes);
}

/// It reports hits before t_min, but finds no small triangle: made small, every case is right that has no
/// hit.
Answer before_t_min_unless_small(const Case& one) {
  const Answer of_line = answer<Fault::absolute_epsilon>(on_whole_line(one));
  return numbers_in(of_line).empty() ? of_line : answer<Fault::ignores_t_min>(one);
}

TEST(Cover, TakesNoCureThatSilencesTheSubject) {
  const Causes causes = causes_of("triangle", before_t_min_unless_small);
  EXPECT_FALSE(causes.contains("smaller-scene")) << *causes.begin();
  EXPECT_TRUE(causes.contains("ignores-t-min") || causes.contains("hits-before-t-min"))
      << testing::PrintToString(causes);
}

/// Every hit of a sphere whose radius is off by up to a fifth of a percent, and t off by as much.
Answer of_approximate_sphere(const Case& one) {
  Case other = one;
  auto& asked = std::get<RayQuestion>(other.question);
  const double share = 1e-3 * (1.1 + std::sin(1e3 * asked.ray.direction.x + asked.ray.origin.y));
  std::get<Sphere<double>>(asked.shape).radius *= 1 - share;
  RayAnswer answer;
  for (const double t : numbers_in(oracle::answer(on_whole_line(other))))
    if (in_interval(asked.ray, t * (1 - share))) answer.hits.push_back(t * (1 - share));
  return answer;
}

TEST(Cover, NamesOneApproximationInWhichVerdictsAndNumbersAreWrong) {
  EXPECT_EQ(causes_of("sphere", of_approximate_sphere), Causes{"approximate-throughout"});
}

TEST(Cover, TakesOfMistakesThatExplainNearlyAsManyTheOneLeastContradicted) {
  using Counts = std::vector<std::size_t>;
  const auto best = [](const Counts& explained, const Counts& contradicted) {
    const auto from = [](const Counts& counts) {
      return [&](std::size_t mistake) { return counts[mistake]; };
    };
    return diagnosis::best_balanced(explained.size(), from(explained), from(contradicted));
  };
  EXPECT_EQ(best({10, 40, 37, 38}, {0, 9, 2, 5}), 2U);
  EXPECT_EQ(best({10, 40, 30}, {0, 9, 0}), 1U) << "30 are far fewer than 40";
  EXPECT_EQ(best({0, 0}, {5, 0}), 0U) << "nothing is explained";
}

/// A ray is taken for parallel where |n·d| is below the machine epsilon of float, whatever the precision.
Answer above_float_epsilon(const Case& one) {
  const Answer exact = oracle::answer(one);
  const auto missed = find_hypothesis("slope-float-epsilon")->predict(one, exact);
  return missed.empty() ? exact : missed.front();
}

TEST(Cover, NamesOneEpsilonOfBothPrecisions) {
  EXPECT_EQ(causes_of("plane", above_float_epsilon), Causes{"slope-float-epsilon"});
}

/// Whatever is nearer to a side than 3e-4 is on the boundary: between two of the limits that are known.
Answer near_the_boundary(const Case& one) {
  const Answer exact = oracle::answer(one);
  const Answers near = diagnosis::within_of_boundary(one, exact, 3e-4);
  return near.empty() ? exact : near.front();
}

TEST(Cover, NamesOneLimitWhereTheRightOneLiesBetweenTwoThatAreKnown) {
  const Causes causes = causes_of("point_in_polygon", near_the_boundary);
  EXPECT_EQ(causes.size(), 1U) << testing::PrintToString(causes);
  EXPECT_TRUE(causes.begin()->starts_with("boundary-near-")) << testing::PrintToString(causes);
}

/// Back faces are culled where the transform mirrors.
Answer culled_under_mirrors(const Case& one) {
  const auto& transform = std::get<RayQuestion>(one.question).transform;
  const bool is_mirrored = transform && glm::determinant(glm::dmat3(*transform)) < 0;
  return is_mirrored ? answer<Fault::culls_back>(one) : oracle::answer(one);
}

TEST(Cover, SaysWhereAloneAFaultShows) {
  const Subject subject = subject_of("triangle", culled_under_mirrors);
  const Complaint found = complaint(subject, *find_property("verdict"), Precision::float64);
  const std::vector<const Complaint*> only{&found};
  const std::vector<Diagnosis> groups = diagnose_together(only).front();
  ASSERT_EQ(groups.size(), 1U) << in_words(groups);
  EXPECT_EQ(groups.front().cause, find_hypothesis("culls-back-faces")) << in_words(groups);
  EXPECT_TRUE(groups.front().sentence.ends_with(", but only under a transform that mirrors"))
      << groups.front().sentence;
}

}  // namespace
}  // namespace rayproof::faulty
