#include "viz/page/page.hpp"

#include <fmt/format.h>

#include <cstring>

#include "viz/flat/stage_picture.hpp"
#include "viz/page/script/embedded.hpp"
#include "viz/picture/palette.hpp"
#include "viz/picture/svg.hpp"
#include "viz/walkthrough/stage_of.hpp"

namespace rayproof::viz {
namespace {

/// Without "</", "<!" and "<s", which HTML reads even within a script.
std::string in_script(std::string json) {
  for (std::size_t at = json.find('<'); at != std::string::npos; at = json.find('<', at + 1))
    if (at + 1 < json.size() && std::strchr("/!sS", json[at + 1])) json.replace(at, 1, "\\u003c");
  return json;
}

CaseReport report_of(const Case& one, const Answer* exact, const Answer* claimed) {
  CaseReport report{.one = one, .exact = *exact};
  if (claimed != nullptr) report.claimed = *claimed;
  return report;
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

std::string case_still(const Case& one, const Answer* exact, const Answer* claimed) {
  return to_svg(case_picture(report_of(one, exact, claimed)));
}

std::string figure_of(const CaseReport& report) {
  const std::string still = to_svg(case_picture(report));
  if (*three_script == '\0') return still;
  return "<div class=\"case\">" + still + json_element("", space_json(case_views(report))) + "</div>";
}

std::string case_figure(const Case& one, const Answer* exact, const Answer* claimed) {
  return figure_of(report_of(one, exact, claimed));
}

}  // namespace rayproof::viz
