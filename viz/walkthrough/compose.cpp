#include "viz/walkthrough/compose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/reader.hpp"
#include "case/reader/field.hpp"
#include "viz/scene/items.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/lesson.hpp"
#include "viz/walkthrough/stage_values.hpp"

namespace rayproof::viz {
namespace {

double lost_by(const StageValue& value) { return worst_component(value).bits_lost; }

/// Of the run's values that are computed, the one that lost most.
std::optional<StageValue> worst_of(const Walkthrough& walk) {
  std::optional<StageValue> worst;
  for (const WalkStep& step : walk.steps) {
    for (const StageValue& value : grouped(step.values)) {
      if (value.components.front().formula != nullptr && (!worst || lost_by(value) > lost_by(*worst)))
        worst = value;
    }
  }
  return worst;
}

/// How far the value is off, as an arrow in the world or along the picture's right.
glm::dvec3 error_of(const StageValue& value, const Setting& setting) {
  const auto error = [&](std::size_t i) {
    return i < value.components.size() ? value.components[i].error : 0.0;
  };
  if (value.components.size() > 1) return {error(0), error(1), error(2)};
  return error(0) * setting.camera.right;
}

Lesson read_lesson(const Field& field) {
  ObjectReader reader(field);
  const auto text_of = [&](const char* name) {
    const auto given = reader.find(name);
    return given ? read_string(*given) : std::string();
  };
  Lesson lesson{.name = text_of("name"),
                .group = text_of("group"),
                .title = text_of("title"),
                .sentence = text_of("sentence"),
                .case_text = std::string(reader.need("case").node().text),
                .method = text_of("method"),
                .beside = text_of("beside"),
                .first = text_of("first"),
                .runs = text_of("runs"),
                .source = text_of("source"),
                .conclusion = text_of("conclusion")};
  if (const auto notes = reader.find("notes")) {
    for (const Field& note : notes->elements("must be a list of notes")) {
      const std::vector<Field> parts = note.elements("must be a step's title and words", 2);
      lesson.notes.push_back({read_string(parts[0]), read_string(parts[1])});
    }
  }
  reader.refuse_unknown();
  const auto* const own = std::ranges::find(composers, lesson.name, &Composer::lesson);
  if (own != composers.end()) lesson.compose = own->compose;
  return lesson;
}

}  // namespace

const WalkValue& value_named(std::string_view name, const Walkthrough& walk) {
  for (auto step = walk.steps.rbegin(); step != walk.steps.rend(); ++step) {
    const auto found = std::find_if(step->values.rbegin(), step->values.rend(),
                                    [&](const WalkValue& value) { return value.name == name; });
    if (found != step->values.rend()) return *found;
  }
  throw std::logic_error("no value " + std::string(name) + " in this run");
}

StageStep difference_of_values(const Walkthrough& walk, const Setting& setting, Precision precision) {
  StageStep step{.title = comparison_title, .view = setting.near};
  const auto worst = worst_of(walk);
  if (!worst || lost_by(*worst) == 0) {
    step.caption = "Float result and exact result are the same: no value of this run is rounded.";
    return step;
  }
  step.caption = fmt::format("Of all values {} lost the most, {:.1f} of {} bits: exact {}, computed {}.",
                             worst->name, lost_by(*worst), worst_component(*worst).digits, exact_of(*worst),
                             shown(*worst, precision));
  const glm::dvec3 error = error_of(*worst, setting);
  const double size = glm::length(error);
  if (!(size > 0) || !std::isfinite(size)) return step;
  step.is_apart = true;
  step.magnification = 1.5 / size;
  const glm::dvec3 tip = 1.5 / size * error;
  step.view = {0.5 * tip, 0.75};  // room for the words at both ends
  step.items = {segment(Role::edge, {0, 0, 0}, tip, "off by " + rough(size, 3)),
                point(Role::exact, {0, 0, 0}, worst->name + " exact"),
                point(Role::claimed, tip, worst->name + " as computed")};
  return step;
}

Setting surface_setting(const CaseReport& report, Items surface, double t_end) {
  Setting setting = setting_of(report);
  const Ray<double>& ray = std::get<RayQuestion>(report.one.question).ray;
  setting.scene = std::move(surface);
  setting.scene.push_back(arrow(Role::ray, ray.origin, ray.origin + t_end * ray.direction, "p(t)"));
  setting.scene.push_back(point(Role::ray, ray.origin, "o"));
  setting.near = setting.wide = view_of(extent_of(setting.scene, setting.camera), setting.camera);
  setting.spaces.clear();
  setting.slider->from = 0;
  setting.slider->to = t_end;
  setting.slider->readouts.clear();
  return setting;
}

Stage run_stage(const CaseReport& report, const Walkthrough& walk, const Setting& setting) {
  Stage stage = composed_stage(report, walk, setting);
  stage.steps.push_back(difference_of_values(walk, setting, report.one.precision));
  return stage;
}

void begin_anew(Stage& stage, std::string_view title) {
  for (StageStep& step : stage.steps)
    if (step.title.starts_with(title)) step.begins_anew = true;
}

const std::vector<Lesson>& lessons() {
  static const std::vector<Lesson> all = [] {
    const json::Document document = json::parse(lessons_text);
    std::vector<Lesson> list;
    for (const Field& field : Field{.document = &document}.elements("must be a list of lessons"))
      list.push_back(read_lesson(field));
    return list;
  }();
  return all;
}

std::vector<const Lesson*> lessons_of(std::string_view topic) {
  std::vector<const Lesson*> found;
  for (const Lesson& lesson : lessons()) {
    if (lesson.name == topic) return {&lesson};
    if (topic == "all" || lesson.group == topic) found.push_back(&lesson);
  }
  return found;
}

Stage stage_of(const Lesson& lesson, const ReportCase& report_on) {
  const Case one = read_case(lesson.case_text);
  Stage stage = lesson.compose != nullptr ? lesson.compose(one, report_on)
                : lesson.beside.empty()   ? stage_of(report_on(one, lesson.method))
                                          : stage_beside(one, report_on, lesson.method, lesson.beside);
  const auto say = [](std::string& place, const std::string& words) {
    if (!words.empty()) place = words;
  };
  say(stage.steps.front().title, lesson.first);
  say(stage.method, lesson.runs);
  say(stage.source, lesson.source);
  say(stage.conclusion, lesson.conclusion);
  for (const auto& [title, words] : lesson.notes) {
    StageStep& step = stage.steps.at(place_of(stage.steps, title));
    const std::size_t end = step.caption.starts_with(step.words) ? step.words.size() : step.caption.size();
    const std::string space = end == 0 ? "" : " ";
    step.caption.insert(end, space + words + (end == 0 && !step.caption.empty() ? " " : ""));
    step.words += (step.words.empty() ? "" : " ") + words;
  }
  stage.name = lesson.name;
  stage.title = lesson.title;
  stage.sentence = lesson.sentence;
  return stage;
}

}  // namespace rayproof::viz
