/// \file
/// What a lesson's captions say of its own case.

#include "case/reader.hpp"
#include "generators/generators.hpp"
#include "unit/viz/stage_data.hpp"
#include "unit/viz/walkthrough/captions/lesson_caption.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {
namespace {

bool speaks_of(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

std::vector<LessonClaim> all_lesson_claims() {
  std::vector<LessonClaim> all;
  for (const auto group : {ray_lesson_claims, flat_lesson_claims, polygon_lesson_claims, solid_lesson_claims,
                           surface_lesson_claims, number_lesson_claims, comparison_claims}) {
    const std::vector<LessonClaim> more = group();
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

TEST(LessonCaptions, EverySentenceIsKnownAndTrueOfTheLessonsCase) {
  const std::vector<LessonClaim> claims = all_lesson_claims();
  for (const Lesson& lesson : lessons())
    expect_true_sentences(stage_of(lesson, report_lesson), kernel_claims(), claims);
}

TEST(LessonCaptions, PolygonLessonsAreTrueOfRandomPolygons) {
  const std::vector<LessonClaim> claims = all_lesson_claims();
  std::size_t count = 0;
  for (const Family& family : families()) {
    if (family.topic != std::string("point_in_polygon")) continue;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      for (const char* lesson : {"polygon-parity", "polygon-vertex-trap"}) {
        const Case one = family.generate(seed, Precision::float32);
        expect_true_sentences(lessons_of(lesson).front()->compose(one, report_lesson), kernel_claims(),
                              claims);
        ++count;
      }
    }
  }
  EXPECT_GT(count, 300U);
}

TEST(LessonCaptions, EveryShrunkCaseOfThePropertyTestStillDisagrees) {
  const Stage stage = stage_of(*lessons_of("property-test").front(), report_lesson);
  EXPECT_TRUE(speaks_of(stage.steps.at(0).caption, "They agree."));
  for (std::size_t i = 1; i < 5; ++i) EXPECT_TRUE(speaks_of(stage.steps.at(i).caption, "They differ.")) << i;
}

TEST(LessonCaptions, OnlyAStartBelowTheSurfaceMeetsItAgain) {
  const Stage stage = stage_of(*lessons_of("acne").front(), report_lesson);
  std::size_t acne = 0;
  for (const StageStep& step : stage.steps) {
    if (!step.title.starts_with("Start by")) continue;
    const bool is_below = speaks_of(step.caption, "below the surface");
    EXPECT_EQ(speaks_of(step.caption, "acne"), is_below) << step.caption;
    acne += is_below ? 1 : 0;
  }
  EXPECT_EQ(acne, 2U);  // no offset, and one that is less than the rounding
}

}  // namespace
}  // namespace rayproof::viz
