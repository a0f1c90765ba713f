#include <gtest/gtest.h>

#include <algorithm>

#include "unit/viz/stage_data.hpp"
#include "viz/stage/lesson.hpp"
#include "viz/stage/stage_values.hpp"
#include "viz/stage/words.hpp"

namespace rayproof::viz {
namespace {

Stage lesson(const char* name) { return stage_of(*lessons_of(name).front(), tell_lesson); }

const StageStep& step_called(const Stage& stage, const std::string& title) {
  const auto found = std::find_if(stage.steps.begin(), stage.steps.end(),
                                  [&](const StageStep& step) { return step.title.find(title) == 0; });
  if (found == stage.steps.end()) throw std::logic_error(stage.name + " has no step " + title);
  return *found;
}

bool has_label(const StageStep& step, const std::string& label) {
  return std::any_of(step.items.begin(), step.items.end(),
                     [&](const StageItem& item) { return item.label == label; });
}

TEST(StageWords, AStepThatNamesNothingPutsInTheNumbersThatItUses) {
  const std::string slabs = step_called(lesson("slabs"), "Meet both planes").caption;
  EXPECT_NE(slabs.find("(min - o) / d = (1.6000001, 1.1, -1.8) / (0.9, 0.7, -0.4)"), std::string::npos)
      << slabs;
  const std::string inverse = step_called(lesson("conservative"), "Meet both planes").caption;
  EXPECT_NE(inverse.find("(min - o)·(1/d) = (1.5, 4, -0.5)·(0.6666667, 0.15873015, 12)"), std::string::npos)
      << inverse;
  const std::string ends = step_called(lesson("cylinder"), "Meet the planes of both ends").caption;
  EXPECT_NE(ends.find("z = 0 and z = 2.2."), std::string::npos) << ends;
}

TEST(StageWords, NumbersThatTheKernelDoesNotNameAreLeftOut) {
  const auto nameless = [](const std::string& /*name*/) { return std::string(); };
  EXPECT_EQ(words_for("Meet the planes of both ends", nameless),
            "Between the two planes the ray is at the cylinder's height.");
  EXPECT_EQ(words_for("A step of no kernel", nameless), "");
}

TEST(StageWords, AVectorOfThePlaneIsPutInWithTwoComponentsWhateverHadItsNameBefore) {
  const std::string caption = step_called(lesson("cylinder"), "Find the point nearest the axis").caption;
  EXPECT_NE(caption.find("l = f + t_c·d = (-2.125, -1) + 2.3919487·(0.875, 0.44444448) ="), std::string::npos)
      << caption;
}

TEST(StageWords, TheSideOfAnEdgeIsTheOneThatTheKernelHas) {
  const Stage leak = lesson("leak");
  for (const char* which : {"Woop, the first", "Woop, the second"}) {
    const StageStep& step = step_called(leak, which);
    for (const StageValue& value : step.values) {
      if (value.name == "D") continue;
      const double volume = value.components.front().value;
      EXPECT_TRUE(has_label(step, value.name + (volume > 0 ? " > 0" : " < 0")))
          << which << ": " << value.name;
    }
  }
}

TEST(StageWords, AStepWithoutRootsIsNotPartedIntoSlidesThatShowNothing) {
  const Stage far = lesson("far-sphere");
  EXPECT_EQ(step_called(far, "Apply the quadratic formula").title, "Apply the quadratic formula");
}

TEST(StageWords, RootsAreNumberedByTheirSizeOrNotAtAll) {
  ASSERT_FALSE(lessons_of("quadratics").empty());
  for (const Lesson* one : lessons_of("quadratics")) {
    const Stage stage = stage_of(*one, tell_lesson);
    double x0 = NAN, x1 = NAN;
    for (const StageStep& step : stage.steps) {
      for (const StageValue& value : step.values) {
        if (value.name == "x₀") x0 = value.components.front().exact_value;
        if (value.name == "x₁") x1 = value.components.front().exact_value;
      }
    }
    EXPECT_FALSE(x0 > x1) << one->name;
  }
}

}  // namespace
}  // namespace rayproof::viz
