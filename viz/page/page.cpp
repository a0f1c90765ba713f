#include "viz/page/page.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cstring>

#include "case/escape.hpp"
#include "case/writer.hpp"
#include "properties/report/page_style.hpp"
#include "viz/flat/stage_picture.hpp"
#include "viz/page/script/embedded.hpp"
#include "viz/picture/picture.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {
namespace {

/// Without "</", "<!" and "<s", which HTML reads even within a script.
std::string in_script(std::string json) {
  for (std::size_t at = json.find('<'); at != std::string::npos; at = json.find('<', at + 1))
    if (at + 1 < json.size() && std::strchr("/!sS", json[at + 1])) json.replace(at, 1, "\\u003c");
  return json;
}

/// Data for a script, with an id or without.
std::string json_element(const std::string& id, const std::string& json) {
  const std::string name = id.empty() ? "" : fmt::format(" id=\"{}\"", id);
  return fmt::format("<script type=\"application/json\"{}>{}</script>\n", name, in_script(json));
}

CaseReport report_of(const Case& one, const Answer* exact, const Answer* claimed) {
  CaseReport report{.one = one, .exact = *exact};
  if (claimed != nullptr) report.claimed = *claimed;
  return report;
}

std::string legend(const Stage& stage) {
  std::string html = "<ul class=\"legend paint\" aria-label=\"Legend\">\n";
  std::vector<ShownItem> all;
  for (std::size_t i = 0; i < stage.steps.size(); ++i) {
    const std::vector<ShownItem> shown = shown_in(stage, i);
    all.insert(all.end(), shown.begin(), shown.end());
  }
  for (const LegendEntry& entry : legend_of(stage, all)) {
    html += fmt::format("<li><svg width=\"22\" height=\"16\" aria-hidden=\"true\">{}</svg>{}</li>\n",
                        to_svg(legend_sign(entry, {11, 8})), entry.text);
  }
  if (stage.slider) {
    html +=
        "<li><svg width=\"22\" height=\"16\" aria-hidden=\"true\"><path class=\"f ray\" d=\"M11 2l-6 "
        "11h12Z\"/></svg>the slider's point</li>\n";
  }
  return html + "</ul>\n";
}

std::string slider(const Stage& stage) {
  if (!stage.slider) return "";
  const bool is_float = stage.precision == Precision::float32;
  return fmt::format(fmt::runtime(slider_html), fmt::arg("symbol", stage.slider->symbol),
                     fmt::arg("line", stage.slider->symbol == "t" ? "ray" : "axis"),
                     fmt::arg("precision", name_of(stage.precision)),
                     fmt::arg("finer", is_float ? "in double" : ""));
}

std::string buttons(const Stage& stage) {
  std::string all;
  for (std::size_t i = 1; i <= stage.steps.size(); ++i) {
    all += fmt::format("<button type=\"button\" title=\"{1}\" aria-label=\"Step {0}: {1}\">{0}</button>", i,
                       html_text(stage.steps[i - 1].title));
  }
  return all;
}

std::string method_line(const Stage& stage) {
  if (stage.method.empty()) return "";
  return fmt::format("<p class=\"soft\">{} in {}{}</p>\n", escaped(stage.method), name_of(stage.precision),
                     stage.source.empty() ? "" : ". Source: " + escaped(stage.source));
}

std::string capitalised(std::string word) {
  if (!word.empty()) word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
  return word;
}

std::string head(const std::string& title) {
  return html_head(title, page_style_sheet + scene_style() + role_style(".paint")) +
         "<link rel=\"icon\" href=\"data:,\">\n</head>\n";
}

}  // namespace

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

std::string stage_page(const Stage& stage, const Still& still, const PageSurroundings& beside) {
  const std::string conclusion = fmt::format("<p class=\"conclusion\">{}</p>\n", html_text(stage.conclusion));
  const bool has_figure = !beside.figure.empty();
  std::string steps;
  for (std::size_t i = 0; i < stage.steps.size(); ++i) steps += step_section(stage, i, still);
  const std::string gallery =
      fmt::format("<p class=\"screen\"><a href=\"{}\">All walkthroughs</a></p>\n", escaped(beside.gallery));
  const std::string script = beside.script.empty()
                                 ? "<script>\n" + shared_script() + "</script>\n"
                                 : fmt::format("<script src=\"{}\"></script>\n", escaped(beside.script));
  using fmt::arg;
  return head(stage.title) +
         fmt::format(
             fmt::runtime(page_html), arg("flat", stage.camera.is_flat ? " class=\"flat\"" : ""),
             arg("gallery", beside.gallery.empty() ? "" : gallery), arg("title", html_text(stage.title)),
             arg("sentence", html_text(stage.sentence)), arg("method", method_line(stage)),
             arg("above", has_figure ? conclusion + "<figure>\n" + beside.figure + "</figure>\n" : ""),
             arg("first", beside.first_step), arg("buttons", buttons(stage)), arg("slider", slider(stage)),
             arg("legend", legend(stage)), arg("steps", steps), arg("below", has_figure ? "" : conclusion),
             arg("case", escaped(write_case(stage.one))),
             arg("data", json_element("stage", stage_json(stage)) + json_element("space", space_json(stage))),
             arg("script", script));
}

std::string case_page(const CaseReport& report, const std::string& script) {
  const Stage stage = stage_of(report);
  return stage_page(stage, flat_still,
                    {.script = script, .figure = figure_of(report), .first_step = stage.decisive_step});
}

std::string gallery_page(const std::vector<GalleryEntry>& entries, const Still& still) {
  std::string html =
      head("Walkthroughs") +
      "<body>\n<main>\n<h1>Walkthroughs</h1>\n<p class=\"lesson\">A ray meets a shape, step by "
      "step, to the last digit. Every number is what the code itself computes.</p>\n";
  std::string group;
  for (const GalleryEntry& entry : entries) {
    if (entry.group != group) {
      html += fmt::format("{}<h2>{}</h2>\n<ul class=\"gallery\">\n", group.empty() ? "" : "</ul>\n",
                          escaped(capitalised(entry.group)));
      group = entry.group;
    }
    const std::size_t middle = entry.stage->steps.size() / 2;
    html += fmt::format("<li><a href=\"{}\">{}<b>{}</b><br><span class=\"soft\">{}</span></a></li>\n",
                        escaped(entry.file), still(*entry.stage, middle), html_text(entry.stage->title),
                        html_text(entry.stage->sentence));
  }
  return html + (group.empty() ? "" : "</ul>\n") + "</main>\n</body>\n</html>\n";
}

}  // namespace rayproof::viz
