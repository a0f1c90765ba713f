/// \file
/// What a lesson's captions say of its own case.

#include <cmath>

#include "case/reader.hpp"
#include "unit/viz/captions/caption.hpp"
#include "unit/viz/stage_data.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {
namespace {

bool speaks_of(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

/// Of a lesson's own case: what its captions say of signs and sizes.
TEST(LessonCaptions, ALessonsOwnNumbersAreThoseOfItsCase) {
  const auto numbers_of = [](const char* lesson) {
    const Lesson& one = *lessons_of(lesson).front();
    return report_lesson(read_case(one.case_text), one.method);
  };
  const CaseReport far = numbers_of("far-sphere");
  const NumbersByName n(*far.walk, far.walk->steps.size() - 1);
  const auto b = static_cast<float>(n.rounded("b")), a = static_cast<float>(n.rounded("a")),
             c = static_cast<float>(n.rounded("c"));
  EXPECT_EQ(b * b, 6560707584.0F);
  EXPECT_EQ(4 * a * c, 6560708608.0F);
  EXPECT_EQ(std::nextafter(6560707584.0F, 7e9F) - 6560707584.0F, 512.0F);

  const CaseReport padded = numbers_of("conservative");
  const NumbersByName p(*padded.walk, padded.walk->steps.size() - 1);
  EXPECT_LT(p["t_exit"], p["t_entry"]);
  EXPECT_LT(p.rounded("t_exit"), p.rounded("t_entry"));
  EXPECT_GE(p.rounded("t_padded"), p.rounded("t_entry"));
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
