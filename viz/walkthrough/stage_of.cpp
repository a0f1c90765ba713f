#include "viz/walkthrough/lesson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "viz/explain/case_report.hpp"
#include "viz/scene/items.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/compose.hpp"
#include "viz/walkthrough/setting.hpp"
#include "viz/walkthrough/stage_values.hpp"

namespace rayproof::viz {
namespace {

std::string first_title(const Case& one) {
  if (std::holds_alternative<Quadratic<double>>(one.question)) return "Look at the equation";
  if (std::holds_alternative<PointAndPolygon<double>>(one.question))
    return "Look at the point and the polygon";
  return fmt::format("Look at the ray and the {}", topic_of(one));
}

/// "o = (0, 0, -5), d = (0, 0, 1), C = (0, 0, 0), r = 1"
std::string inputs_in_words(const std::vector<StageValue>& values, Precision precision) {
  std::string text;
  for (const StageValue& value : values) {
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", value.name, shown(value, precision));
  }
  return text;
}

StageStep first_step(const CaseReport& report, const Walkthrough* walk, const Setting& setting) {
  StageStep step;
  step.title = first_title(report.one);
  if (walk != nullptr) step.values = grouped(walk->inputs);
  step.caption = "What is given";
  step.caption += step.values.empty() ? "." : ": " + inputs_in_words(step.values, report.one.precision) + ".";
  step.view = setting.starts_far() ? setting.near : setting.wide;
  if (setting.starts_far()) step.items.push_back(*setting.far_start);
  return step;
}

std::string title_of(const CaseReport& report) {
  if (report.walk) return report.walk->title;
  return report.method.empty() ? "The exact answer" : report.method;
}

std::string name_of(const CaseReport& report) {
  std::string name = report.method.empty() ? topic_of(report.one) : report.method;
  std::replace(name.begin(), name.end(), '/', '-');
  return name;
}

Stage bare_stage(const CaseReport& report, const Setting& setting) {
  Stage stage;
  stage.name = name_of(report);
  stage.title = title_of(report);
  stage.sentence =
      report.one.note.empty() ? headline_of(report.one, &report.exact, report.claim()) : report.one.note;
  stage.method = report.method;
  stage.conclusion = conclusion_of(report);
  stage.one = report.one;
  stage.precision = report.one.precision;
  stage.digits = report.one.precision == Precision::float32 ? 24 : 53;
  stage.scene = setting.scene;
  stage.slider = setting.slider;
  stage.camera = setting.camera;
  return stage;
}

/// More steps than this, with the first and the last, nobody follows.
constexpr std::size_t most_steps = 8;

/// Splits steps that draw several things, from the first on, as long as there is room.
void add_steps(Stage& stage, const CaseReport& report, const Walkthrough& walk, const Setting& setting,
               bool may_split) {
  stage.source = walk.source;
  const std::size_t needed = walk.steps.size() + 2;
  std::size_t room = may_split && needed < most_steps ? most_steps - needed : 0;
  const StepSpace* before = nullptr;
  Items earlier;
  for (std::size_t i = 0; i < walk.steps.size(); ++i) {
    const StepSpace* const space = space_of(setting, walk, i);
    if (space != before) earlier.clear();
    before = space;
    const Setting here = space != nullptr ? in_space(setting, *space) : setting;
    std::vector<StageStep> parts = kernel_steps(report, walk, i, here, true);
    if (parts.size() - 1 > room) parts = kernel_steps(report, walk, i, here, false);
    room -= parts.size() - 1;
    for (StageStep& step : parts) {
      if (space != nullptr) show_in_space(step, *space, NumbersByName(walk, i), setting.camera, earlier);
      stage.steps.push_back(std::move(step));
    }
  }
}

/// Finds the step that spoilt the answer, and shows the number on which it hangs once more at the end.
void find_decisive_step(Stage& stage, const CaseReport& report) {
  const bool is_right =
      report.claim() == nullptr || (report.walk && report.walk->outcome == Faithfulness::faithful);
  if (!is_right) stage.decisive_step = stage.steps.size() - 1;
  if (!report.walk || !report.walk->decisive_loss) return;
  const PrecisionLoss& loss = *report.walk->decisive_loss;
  for (std::size_t i = 0; i < stage.steps.size(); ++i) {
    const auto value = std::ranges::find(stage.steps[i].values, loss.name, &StageValue::name);
    if (value == stage.steps[i].values.end()) continue;
    if (!is_right) stage.decisive_step = i;
    stage.steps.back().values.push_back(*value);
    return;
  }
}

}  // namespace

void widen_views(Stage& stage, const Setting& setting) {
  constexpr double most = 2.4;  // more would make the shape a speck; such a step looks from wide off
  const auto needed = [&](const StageView& view, const StageStep& step) {
    return radius_for(view, step.items, stage.camera);
  };
  double radius = setting.near.radius;
  for (const StageStep& step : stage.steps) {
    const double wanted = step.is_apart ? 0 : needed(setting.near, step);
    if (wanted <= most * setting.near.radius) radius = std::max(radius, wanted);
  }
  for (StageStep& step : stage.steps) {
    if (step.is_apart) continue;
    const bool is_near = needed(setting.near, step) <= most * setting.near.radius &&
                         setting.wide.radius <= most * setting.near.radius;
    const bool is_at_shape = step.view.radius == setting.near.radius;
    if (is_near || is_at_shape) {
      step.view = {setting.near.centre, radius};
    } else {
      step.view.radius = needed(step.view, step);
    }
  }
}

Stage stage_of(const CaseReport& report) {
  const Setting setting = setting_of(report);
  Stage stage = bare_stage(report, setting);
  stage.steps.push_back(first_step(report, report.walk ? &*report.walk : nullptr, setting));
  if (report.walk) add_steps(stage, report, *report.walk, setting, true);
  stage.steps.push_back(difference_step(report, setting));
  find_decisive_step(stage, report);
  widen_views(stage, setting);
  return stage;
}

Stage composed_stage(const CaseReport& report, const Walkthrough& walk, const Setting& setting) {
  const std::set<std::string> recorded = recorded_names(walk);
  for (const Binding& binding : setting.bindings) {
    if (!recorded.contains(binding.name))
      throw std::logic_error("a lesson draws " + binding.name + ", which its run does not name");
  }
  Stage stage = bare_stage(report, setting);
  stage.steps.push_back(first_step(report, &walk, setting));
  add_steps(stage, report, walk, setting, false);
  widen_views(stage, setting);
  return stage;
}

}  // namespace rayproof::viz
