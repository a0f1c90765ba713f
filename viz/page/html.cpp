#include <fmt/format.h>

#include "case/escape.hpp"
#include "case/writer.hpp"
#include "properties/report/page_style.hpp"
#include "viz/explain/answers.hpp"
#include "viz/explain/case_report.hpp"
#include "viz/page/case_figure.hpp"
#include "viz/page/html_text.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

/// `exact` is the heading over the exact numbers: an input is exact as it is stored.
std::string table(const std::vector<WalkValue>& values, Precision precision, const char* exact = "exact") {
  if (values.empty()) return "";
  std::string html = fmt::format(
      "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Values\"><table>\n<tr><th "
      "scope=\"col\">name</th>"
      "<th scope=\"col\">{}</th><th scope=\"col\">{}</th><th scope=\"col\">bits lost</th>"
      "<th scope=\"col\">error bound</th><th scope=\"col\">computed as</th></tr>\n",
      name_of(precision), exact);
  for (const WalkValue& v : values) {
    html += fmt::format(
        "<tr><td><b>{}</b></td><td>{}</td><td>{}</td><td{}>{}</td><td>{}</td><td>{}</td></tr>\n",
        escaped(v.name), shown(v.value, precision), v.exact, v.bits_lost >= 3 ? " class=\"lost\"" : "",
        v.bits_lost < 0.05 ? "–" : fmt::format("{:.1f}", v.bits_lost),
        v.error_bound == 0 ? "–" : rough(v.error_bound, 2), escaped(computed_as(v)));
  }
  return html + "</table></div>\n";
}

std::string step_section(std::size_t number, const WalkStep& step, bool is_worst, Precision precision) {
  return fmt::format("<section class=\"step{}\"><h2>{}. {}</h2>\n<p>{}</p>\n{}{}</section>\n",
                     is_worst ? " worst" : "", number, escaped(step.title), escaped(step.meaning),
                     step.caption.empty() ? "" : fmt::format("<p>{}</p>\n", escaped(step.caption)),
                     table(step.values, precision));
}

std::string walk_sections(const Walkthrough& walk) {
  std::string html =
      fmt::format("<h2>{}</h2>\n<p class=\"soft\">{}</p>\n", escaped(walk.title), escaped(walk.source));
  html += "<details><summary>The inputs</summary>\n" + table(walk.inputs, walk.precision, "stored value") +
          "</details>\n";
  html +=
      "<div id=\"walk\">\n<nav aria-label=\"Steps\"><button type=\"button\">First</button><button "
      "type=\"button\">← "
      "Back</button><button type=\"button\">Next →</button><span id=\"place\" aria-live=\"polite\"></span>"
      "<button type=\"button\">All steps</button></nav>\n";
  for (std::size_t i = 0; i < walk.steps.size(); ++i) {
    const bool is_worst = walk.decisive_loss && walk.decisive_loss->step == walk.steps[i].title;
    html += step_section(i + 1, walk.steps[i], is_worst, walk.precision);
  }
  return html + "</div>\n";
}

}  // namespace

std::string html_page(const CaseReport& report, const std::string& script) {
  const std::string headline = headline_of(report.one, &report.exact, report.claim());
  std::string html = html_head(headline, steps_style + scene_style()) +
                     fmt::format("</head>\n<body>\n<main>\n<h1>{}</h1>\n",
                                 escaped(report.method.empty() ? topic_of(report.one) : report.method));
  if (!report.one.note.empty()) html += fmt::format("<p class=\"soft\">{}</p>\n", escaped(report.one.note));
  if (!report.method.empty())
    html += fmt::format("<p class=\"conclusion\">{}</p>\n", escaped(conclusion_of(report)));
  html += "<figure>\n" + figure_of(report) + "</figure>\n";
  if (report.walk) html += walk_sections(*report.walk);
  html += fmt::format("<h2>The case</h2>\n<pre>{}</pre>\n", escaped(write_case(report.one)));
  return html + "</main>\n<script>" + page_script + script + "</script>\n</body>\n</html>\n";
}

}  // namespace rayproof::viz
