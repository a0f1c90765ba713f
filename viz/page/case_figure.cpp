#include "viz/page/case_figure.hpp"

#include <fmt/format.h>

#include <cmath>

#include "viz/drawing/svg.hpp"
#include "viz/explain/answers.hpp"
#include "viz/page/script/embedded.hpp"
#include "viz/page/space_json.hpp"
#include "viz/picture/palette.hpp"
#include "viz/scene/items.hpp"
#include "viz/walkthrough/setting.hpp"
#include "viz/walkthrough/stage_of.hpp"

namespace rayproof::viz {
namespace {

std::string in_script(std::string json) {
  for (std::size_t at = json.find("</"); at != std::string::npos; at = json.find("</", at))
    json.replace(at, 2, "<\\/");
  return json;
}

/// The hits of both answers.
Items hits_of(const Stage& stage, const CaseReport& report) {
  Items items;
  if (!stage.slider || stage.slider->symbol != "t") return items;
  const auto mark = [&](Role role, const Answer* answer, const char* label) {
    for (const double t : values_of(answer)) {
      if (!std::isfinite(t)) continue;
      items.push_back(point(role, stage.slider->origin + t * stage.slider->direction, label));
      label = "";
    }
  };
  mark(Role::exact, &report.exact, "exact");
  mark(Role::claimed, report.claim(), "as computed");
  return items;
}

/// The shape with the hits, the whole of it where that is much larger, and the difference magnified.
Stage views_of_case(const CaseReport& report) {
  Stage stage = stage_of(report);
  const Setting setting = setting_of(report);
  StageStep& first = stage.steps.front();
  first.items = hits_of(stage, report);
  stage.slider.reset();
  first.title = "From any side";
  stage.steps.back().title = "Magnified";
  if (setting.wide.radius > 2.4 * setting.near.radius) {
    StageStep near = first;
    near.view = setting.near;
    first.title = "Whole";
    first.begins_anew = true;
    stage.steps.insert(stage.steps.begin(), near);
  }
  return stage;
}

}  // namespace

std::string json_element(const std::string& id, const std::string& json) {
  const std::string name = id.empty() ? "" : fmt::format(" id=\"{}\"", id);
  return fmt::format("<script type=\"application/json\"{}>{}</script>\n", name, in_script(json));
}

std::string shared_script() { return std::string(three_script) + walkthrough_script; }

std::string scene_style() {
  const auto colours = [](const char* RoleColour::*shade) {
    std::string rules;
    const auto add = [&](const RoleColour& one) {
      rules += fmt::format("--role-{}:{};", one.name, one.*shade);
    };
    for (const RoleColour& one : palette) add(one);
    for (const RoleColour& one : {floor_colours.ground, floor_colours.grid, floor_colours.shadow}) add(one);
    return rules;
  };
  return scene_style_sheet +
         fmt::format(":root{{{}}}@media screen and (prefers-color-scheme:dark){{:root{{{}}}}}\n",
                     colours(&RoleColour::light), colours(&RoleColour::dark));
}

std::string case_figure(const Case& one, const Answer* exact, const Answer* claimed) {
  const std::string still = svg_of(one, exact, claimed);
  if (exact == nullptr || *three_script == '\0') return still;
  CaseReport report{.one = one, .exact = *exact};
  if (claimed != nullptr) report.claimed = *claimed;
  return "<div class=\"case\">" + still + json_element("", space_json(views_of_case(report))) + "</div>";
}

}  // namespace rayproof::viz
