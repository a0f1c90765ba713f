#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "generators/generators.hpp"
#include "unit/viz/every_shape.hpp"
#include "unit/viz/stage_data.hpp"
#include "viz/explain/case_report.hpp"
#include "viz/walkthrough/bindings.hpp"
#include "viz/walkthrough/compose.hpp"
#include "viz/walkthrough/lesson.hpp"
#include "viz/walkthrough/setting.hpp"

namespace rayproof::viz {
namespace {

Stage lesson(const char* name) { return stage_of(*lessons_of(name).front(), report_lesson); }

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
  EXPECT_NE(inverse.find("(min - o)·(1/d) = (4, 1.4, -0.5)·(0.25, 0.27027023, 10)"), std::string::npos)
      << inverse;
  const std::string ends = step_called(lesson("cylinder"), "Meet the planes of both ends").caption;
  EXPECT_NE(ends.find("z = 0 and z = 2.2:"), std::string::npos) << ends;
}

/// Every method that can be recorded, on tame cases of every form and on a case of every family.
void for_every_reported_method(const std::function<void(const CaseReport&)>& check) {
  std::vector<Case> cases;
  for (const std::string& shape : shapes()) cases.push_back(with_shape(shape));
  for (const Family& family : families()) cases.push_back(family.generate(7, Precision::float32));
  for (const Case& one : cases) {
    for (const Subject& subject : subjects()) {
      if (subject.topic != topic_of(one)) continue;
      const CaseReport report = report_of(one, &subject);
      if (report.walk) check(report);
    }
  }
}

TEST(StageWords, EveryStepOfEveryMethodSaysInASentenceWhatItMeans) {
  std::set<std::string> titles;
  for_every_reported_method([&](const CaseReport& report) {
    for (const WalkStep& step : report.walk->steps) {
      titles.insert(step.title);
      EXPECT_TRUE(step.meaning.ends_with(".")) << report.method << ": " << step.title << ": " << step.meaning;
      EXPECT_EQ(step.meaning.find_first_of("{}"), std::string::npos) << report.method << ": " << step.meaning;
    }
  });
  EXPECT_GT(titles.size(), 50U);
}

TEST(StageWords, EveryPictureHangsOnANameThatAKernelOfItsTopicRecords) {
  std::set<std::string> recorded;
  std::map<std::string, std::set<std::string>> drawn;
  for_every_reported_method([&](const CaseReport& report) {
    const std::string topic = topic_of(report.one);
    const std::set<std::string> names = recorded_names(*report.walk);
    const NumbersByName n(*report.walk, report.walk->steps.size() - 1);
    for (const Binding& binding : bindings_of(topic)) {
      if (names.contains(binding.name) && !binding.draw(n).empty()) drawn[topic].insert(binding.name);
    }
    recorded.insert(names.begin(), names.end());
  });
  EXPECT_GT(drawn.size(), 5U);
  for (const auto& [topic, names] : drawn) {
    for (const Binding& binding : bindings_of(topic))
      EXPECT_TRUE(names.contains(binding.name)) << "no method of " << topic << " names " << binding.name;
  }
  for (const char* name : gap_names) EXPECT_TRUE(recorded.contains(name)) << name;
}

TEST(StageWords, WhatAStepDrawsAsAHitLiesOnTheRayWhateverTheKernelCallsItsOwnRay) {
  std::size_t hits = 0;
  for (const std::string& shape : shapes()) {
    const Case one = with_shape(shape);
    const Ray<double>& ray = std::get<RayQuestion>(one.question).ray;
    for (const Subject& subject : subjects()) {
      if (subject.topic != topic_of(one)) continue;
      for (const StageStep& step : stage_of(report_of(one, &subject)).steps) {
        for (const StageItem& item : step.items) {
          if (step.is_apart || item.role != Role::claimed || item.form != Form::point) continue;
          ++hits;
          const glm::dvec3 off = glm::cross(item.points[0] - ray.origin, ray.direction);
          EXPECT_LE(glm::length(off), 1e-9) << subject.topic << "/" << subject.name << ": " << step.title;
        }
      }
    }
  }
  EXPECT_GT(hits, 30U);
}

/// A run of one step, which names the number 2.
Walkthrough run_that_names(const char* name) {
  return record(Precision::float32, [&]<class R>(std::type_identity<R>) {
    step<R>("Take two", "It is {two}.");
    (void)named(name, R(2));
  });
}

TEST(StageWords, ASentenceThatSpeaksOfANumberWithoutANameIsAnError) {
  EXPECT_EQ(run_that_names("two").steps.front().meaning, "It is 2.");
  EXPECT_THROW((void)run_that_names("three"), std::logic_error);
}

TEST(StageWords, APictureThatAsksForANameThatTheRunDoesNotHaveIsAnError) {
  const Walkthrough run = run_that_names("two");
  const NumbersByName n(run, 0);
  EXPECT_EQ(n["two"], 2);
  EXPECT_THROW((void)n["three"], std::logic_error);
  EXPECT_THROW((void)n.vector("two"), std::logic_error);
  const CaseReport report = report_lesson(read_case(lessons_of("sphere").front()->case_text), "");
  Setting setting = setting_of(report);
  setting.bindings = {{"two", [](const NumbersByName& /*n*/) { return Items{}; }}};
  EXPECT_EQ(composed_stage(report, run, setting).steps.size(), 2U);
  setting.bindings.push_back({"three", [](const NumbersByName& /*n*/) { return Items{}; }});
  EXPECT_THROW((void)composed_stage(report, run, setting), std::logic_error);
  EXPECT_THROW((void)place_of(run.steps, "Take three"), std::logic_error);
}

TEST(StageWords, AVectorOfThePlaneIsPutInWithTwoComponentsWhateverHadItsNameBefore) {
  const std::string caption = step_called(lesson("cylinder"), "Find the point nearest the axis").caption;
  EXPECT_NE(caption.find("l = f + t_c·d = (-2.125, -0.5555556) + 2.1868618·(0.875, 0.44444448) ="),
            std::string::npos)
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
    const Stage stage = stage_of(*one, report_lesson);
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
