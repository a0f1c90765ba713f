#include "viz/walkthrough/stage_of.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "viz/explain/case_report.hpp"
#include "viz/walkthrough/setting.hpp"

namespace rayproof::viz {
namespace {

bool has_step(const Walkthrough& walk, const std::string& title) {
  return std::ranges::any_of(walk.steps, [&](const WalkStep& step) { return step.title == title; });
}

/// The steps of one run that the other does not have; its last where it has all of them.
void add_different(Stage& stage, const CaseReport& report, const Walkthrough& other, const std::string& who) {
  const Walkthrough& walk = *report.walk;
  const Setting setting = setting_of(report);
  const std::size_t before = stage.steps.size();
  const auto add = [&](std::size_t i) {
    const StepSpace* const space = space_of(setting, walk, i);
    StageStep step =
        kernel_steps(report, walk, i, space != nullptr ? in_space(setting, *space) : setting, false).front();
    Items earlier;
    if (space != nullptr) show_in_space(step, *space, NumbersByName(walk, i), setting.camera, earlier);
    if (!step.title.ends_with("as printed")) step.title = who + ": " + step.title;
    step.begins_anew = stage.steps.size() == before;
    stage.steps.push_back(std::move(step));
  };
  for (std::size_t i = 0; i < walk.steps.size(); ++i) {
    if (!has_step(other, walk.steps[i].title)) add(i);
  }
  if (stage.steps.size() == before) add(walk.steps.size() - 1);
}

}  // namespace

Stage stage_beside(const Case& one, const ReportCase& report_on, const std::string& method,
                   const std::string& right) {
  const CaseReport printed = report_on(one, method);
  const CaseReport mended = report_on(one, right);
  Stage stage = stage_of(printed);
  const StageStep last = stage.steps.back();
  stage.steps.resize(1);
  add_different(stage, printed, *mended.walk, "As printed");
  add_different(stage, mended, *printed.walk, "As it should be");
  widen_views(stage, setting_of(printed));
  StageStep& end = stage.steps.emplace_back(last);
  end.begins_anew = true;
  end.caption += fmt::format(" {} says: {}.", right, answer_in_words(mended));
  return stage;
}

}  // namespace rayproof::viz
