#include <fmt/format.h>

#include <array>

#include "case/reader.hpp"
#include "viz/explain/case_report.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/lesson.hpp"
#include "viz/walkthrough/setting.hpp"

namespace rayproof::viz {
namespace {

struct ShrunkCase {
  const char* title;
  const char* words;
  const char* case_text;  ///< null for the lesson's own
};

constexpr std::array<ShrunkCase, 5> trials{
    {{"Draw a ray and a sphere at random",
      "A generator draws the numbers; the oracle answers exactly, and the method must agree.",
      R"({"precision": "float32", "ray": {"origin": [-3.7, -0.9, 0.4], "direction": [1.3, 0.5, 0.1]},
          "shape": {"type": "sphere", "center": [0.2, 0.1, 0.3], "radius": 1.4}})"},
     {"After many cases that agree, one does not",
      "A verdict that differs from the oracle's breaks the property. Ten numbers, and none of them is round.",
      R"({"precision": "float32", "ray": {"origin": [-2883.1, -878.8, -2395.1], "direction": [1.0544523, 0.32390717, 0.87506]},
          "shape": {"type": "sphere", "center": [9.4, 9.77, 5.56], "radius": 0.55}})"},
     {"Shrink: try a ray along an axis",
      "A simpler case is kept where it still breaks the property: here the direction has one component that "
      "is not 0.",
      R"({"precision": "float32", "ray": {"origin": [9.5, 9.9, -4500.6], "direction": [0, 0, 9]},
          "shape": {"type": "sphere", "center": [9.4, 9.77, 5.56], "radius": 0.55}})"},
     {"Shrink: try the centre at 0",
      "It still breaks: what matters is not where the sphere is, but how far from the ray's origin.",
      R"({"precision": "float32", "ray": {"origin": [0.1, 0.2, -4499.9], "direction": [0, 0, 9]},
          "shape": {"type": "sphere", "center": [0, 0, 0], "radius": 0.55}})"},
     {"Shrink: try small whole numbers",
      "Small whole numbers still break it: a case that can be computed by hand.", nullptr}}};

StageStep trial_step(const ShrunkCase& trial, const Case& last, const ReportCase& report_on) {
  const CaseReport report =
      report_on(trial.case_text != nullptr ? read_case(trial.case_text) : last, "sphere/textbook");
  Stage stage = stage_of(report);
  StageStep step{.title = trial.title, .words = trial.words, .view = setting_of(report).near};
  step.is_apart = step.is_other_space = true;
  const auto& [ray, shape, transform] = std::get<RayQuestion>(report.one.question);
  const auto& sphere = std::get<Sphere<double>>(shape);
  const Precision precision = report.one.precision;
  const bool differ = verdicts_differ(&report.exact, report.claim());
  step.caption =
      fmt::format("{} o = {}, d = {}, C = {}, r = {}. Exact: {}. Computed: {}. {}", trial.words,
                  shown(ray.origin, precision), shown(ray.direction, precision),
                  shown(sphere.center, precision), shown(sphere.radius, precision), verdict_of(&report.exact),
                  verdict_of(report.claim()), differ ? "They differ." : "They agree.");
  step.items = stage.scene;
  for (const double t : values_of(&report.exact)) {
    const bool is_first = t == values_of(&report.exact).front();
    step.items.push_back(
        point(differ ? Role::exact : Role::claimed, ray.origin + t * ray.direction, is_first ? "t₀" : "t₁"));
  }
  return step;
}

}  // namespace

/// A random case, one that fails, and how it is made small.
Stage test_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(one, "sphere/textbook");
  Stage stage = stage_of(report);
  const StageStep last = stage.steps.back();
  stage.steps.clear();
  for (const ShrunkCase& trial : trials) stage.steps.push_back(trial_step(trial, one, report_on));
  stage.steps.push_back(last);
  stage.slider.reset();
  return stage;
}

}  // namespace rayproof::viz
