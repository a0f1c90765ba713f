#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <rayproof/formulas/polygon_sides.hpp>

#include "viz/explain/case_report.hpp"
#include "viz/scene/items.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/lesson.hpp"
#include "viz/walkthrough/setting.hpp"

namespace rayproof::viz {
namespace {

/// Where the ray to the right crosses a side, counted.
Items crossings_of(const PointAndPolygon<double>& question) {
  std::vector<double> crossings;
  polygon::for_each_side(question.vertices, [&](const auto& a, const auto& b) {
    if (!polygon::passes(question.point.y, a, b)) return;
    const double t = polygon::cross_side(question.point, a, b).t;
    if (t > 0) crossings.push_back(t);
  });
  std::sort(crossings.begin(), crossings.end());
  Items items;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    items.push_back(
        point(Role::nearest, {question.point.x + crossings[i], question.point.y, 0}, std::to_string(i + 1)));
  }
  return items;
}

std::string words_of(const Case& one, const Setting& setting) {
  if (const auto* q = std::get_if<Quadratic<double>>(&one.question)) {
    const auto term = [&](double value) {
      return (value < 0 ? "− " : "+ ") + shown(std::abs(value), one.precision);
    };
    return fmt::format("{}·x² {}·x {} = 0", shown(q->a, one.precision), term(q->b), term(q->c));
  }
  return setting.close_up ? setting.close_up->words : "";
}

/// By how much the whole may be larger than the shape so that one view shows both. A view of the shape where
/// the ray doesn't come shows less than it takes room.
double largest_in_one_view(const CaseReport& report, const StageView& near,
                           const std::optional<StageSlider>& ray) {
  constexpr double usual = 2.4;
  if (!ray || !values_of(&report.exact).empty()) return usual;
  const glm::dvec3 way = near.centre - ray->origin, along = glm::normalize(ray->direction);
  return glm::length(way - glm::dot(way, along) * along) > near.radius ? 8 : usual;
}

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

Stage case_views(const CaseReport& report) {
  Stage stage = stage_of(report);
  const Setting setting = setting_of(report);
  StageStep whole = stage.steps.front();
  StageStep magnified = stage.steps.back();
  whole.caption = words_of(report.one, setting);
  whole.view = setting.wide;
  if (const auto* question = std::get_if<PointAndPolygon<double>>(&report.one.question)) {
    // On the boundary nothing depends on how many there are.
    if (std::get<Position>(report.exact) != Position::boundary) whole.items = crossings_of(*question);
  } else if (stage.slider) {
    whole.items = hits_of(*stage.slider, report);
    if (stage.slider->symbol == "x") whole.magnification = glm::length(stage.slider->direction);
  }
  StageStep near = whole;
  near.title = "From any side";
  whole.view.radius = radius_for(whole.view, whole.items, stage.camera);
  const bool is_much_larger =
      whole.view.radius > largest_in_one_view(report, setting.near, stage.slider) * setting.near.radius;
  if (is_much_larger) {
    near.view = setting.near;
    if (setting.far_start) {
      near.items.push_back(*setting.far_start);
      for (StageItem& hit : whole.items) hit.label.clear();  // they are named from nearby
    }
    whole.title = "Whole";
    whole.begins_anew = true;
  }
  stage.steps = {near};
  if (is_much_larger) stage.steps.push_back(whole);
  const double enlarged = enlargement(near, magnified);
  const bool are_equal = report.claim() != nullptr && !values_of(&report.exact).empty() &&
                         !verdicts_differ(&report.exact, report.claim()) &&
                         worst_ulps(&report.exact, report.claim(), report.one.precision) == 0;
  if (magnified.is_apart && !are_equal && enlarged > 2.5) {
    magnified.title = "Magnified";
    stage.steps.push_back(magnified);
  }
  stage.slider.reset();
  return stage;
}

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
