#include "viz/page/page.hpp"

#include <fmt/format.h>

#include <cctype>

#include "case/escape.hpp"
#include "case/writer.hpp"
#include "properties/report/page_style.hpp"
#include "viz/flat/stage_picture.hpp"
#include "viz/page/case_figure.hpp"
#include "viz/page/page_step.hpp"
#include "viz/page/script/embedded.hpp"
#include "viz/page/space_json.hpp"
#include "viz/page/stage_json.hpp"
#include "viz/picture/svg.hpp"
#include "viz/walkthrough/stage_of.hpp"

namespace rayproof::viz {
namespace {

std::string legend(const Stage& stage) {
  std::string html = "<ul class=\"legend paint\" aria-label=\"Legend\">\n";
  std::vector<ShownItem> all;
  for (std::size_t i = 0; i < stage.steps.size(); ++i) {
    const std::vector<ShownItem> shown = shown_in(stage, i);
    all.insert(all.end(), shown.begin(), shown.end());
  }
  for (const LegendEntry& entry : legend_of(all)) {
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
  return fmt::format(
      "<div class=\"slide\"><input id=\"slider\" type=\"range\" min=\"0\" max=\"1000\" step=\"1\" "
      "aria-label=\"{0} along the "
      "{1}\"><output id=\"t\" for=\"slider\"></output></div>\n<div class=\"wide\"><table "
      "class=\"readings\"><thead><tr><th "
      "scope=\"col\">at this {0}</th>"
      "<th scope=\"col\">{2}</th><th scope=\"col\">{3}</th></tr></thead><tbody "
      "id=\"live\"></tbody></table></div>\n",
      stage.slider->symbol, stage.slider->symbol == "t" ? "ray" : "axis", name_of(stage.precision),
      stage.precision == Precision::float32 ? "in double" : "");
}

/// What only a script can fill.
std::string live_part(const Stage& stage) {
  std::string steps;
  for (std::size_t i = 1; i <= stage.steps.size(); ++i) {
    const std::string title = escaped(stage.steps[i - 1].title);
    steps += fmt::format("<button type=\"button\" title=\"{1}\" aria-label=\"Step {0}: {1}\">{0}</button>", i,
                         title);
  }
  return fmt::format(
      "<div id=\"live-part\"><nav class=\"bar\" aria-label=\"Steps\"><button type=\"button\" id=\"back\" "
      "aria-label=\"Step "
      "back\">←</button><span id=\"steps\">{}</span><button type=\"button\" id=\"next\" aria-label=\"Next "
      "step\">→</button>"
      "<button type=\"button\" id=\"reset\">Reset view</button></nav><p id=\"place\" "
      "aria-live=\"polite\"></p>\n"
      "<div id=\"scene\" class=\"scene\" role=\"img\" tabindex=\"0\"></div>\n"
      "<p id=\"magnified\" class=\"soft\"></p>\n{}{}</div>\n",
      steps, slider(stage), legend(stage));
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

std::string stage_page(const Stage& stage, const Still& still, const PageSurroundings& beside) {
  std::string html = head(stage.title);
  html += fmt::format("<body{}>\n<main>\n", stage.camera.is_flat ? " class=\"flat\"" : "");
  if (!beside.gallery.empty())
    html +=
        fmt::format("<p class=\"screen\"><a href=\"{}\">All walkthroughs</a></p>\n", escaped(beside.gallery));
  html +=
      fmt::format("<h1>{}</h1>\n<p class=\"lesson\">{}</p>\n", escaped(stage.title), escaped(stage.sentence));
  if (!stage.method.empty()) {
    html += fmt::format("<p class=\"soft\">{} in {}{}</p>\n", escaped(stage.method), name_of(stage.precision),
                        stage.source.empty() ? "" : ". Source: " + escaped(stage.source));
  }
  const std::string conclusion = fmt::format("<p class=\"conclusion\">{}</p>\n", escaped(stage.conclusion));
  if (!beside.figure.empty()) html += conclusion + "<figure>\n" + beside.figure + "</figure>\n";
  html += "<div id=\"walk\">\n" + live_part(stage) + "<div id=\"texts\">\n";
  for (std::size_t i = 0; i < stage.steps.size(); ++i) html += step_section(stage, i, still);
  html += "</div>\n</div>\n" + (beside.figure.empty() ? conclusion : "");
  html +=
      "<details class=\"screen\"><summary>Keys</summary><p><kbd>←</kbd> <kbd>→</kbd> step back and on, "
      "<kbd>Home</kbd> <kbd>End</kbd> "
      "first and last, <kbd>1</kbd> to <kbd>9</kbd> that step. With the picture in focus: arrows look from "
      "another side, "
      "<kbd>+</kbd> <kbd>-</kbd> nearer and farther. With the slider in focus: arrows move the "
      "point.</p></details>\n";
  html += fmt::format("<details class=\"screen\"><summary>The case</summary><pre>{}</pre></details>\n",
                      escaped(write_case(stage.one)));
  html += "</main>\n" + json_element("stage", stage_json(stage)) + json_element("space", space_json(stage));
  html += beside.script.empty() ? "<script>\n" + shared_script() + "</script>\n"
                                : fmt::format("<script src=\"{}\"></script>\n", escaped(beside.script));
  return html + "</body>\n</html>\n";
}

std::string case_page(const CaseReport& report, const std::string& script) {
  return stage_page(stage_of(report), flat_still, {.script = script, .figure = figure_of(report)});
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
                        escaped(entry.file), still(*entry.stage, middle), escaped(entry.stage->title),
                        escaped(entry.stage->sentence));
  }
  return html + (group.empty() ? "" : "</ul>\n") + "</main>\n</body>\n</html>\n";
}

}  // namespace rayproof::viz
