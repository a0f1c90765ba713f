#include "properties/report/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "case/escape.hpp"
#include "properties/report/page_legend.hpp"
#include "properties/report/page_style.hpp"

namespace rayproof {

namespace {

/// Marks differ in sign and border as well as in colour.
constexpr const char* check_style = R"css(
td.mark { text-align: center; font-weight: 600; }
.holds { color: var(--exact); } .refuted { color: var(--known); } .broken { color: var(--bad); }
.mark.refuted { outline: 1px dashed; outline-offset: -4px; } .mark.broken { outline: 2px solid; outline-offset: -3px; }
p.legend { font-size: .875rem; } p.legend span { display: inline-block; min-width: 1.6em; text-align: center; }
article { border: 1px solid var(--line); border-radius: 6px; padding: 1rem; margin: 0 0 1rem; break-inside: avoid;
          display: grid; grid-template-columns: minmax(0, 3fr) minmax(0, 2fr); gap: 1rem 1.5rem; }
article.declared { border-style: dashed; }
.number { border: 1px solid; border-radius: 4px; padding: 0 .35em; margin-right: .25em; } p.words { font-size: 1.0625rem; }
dl { margin: .5rem 0 0; font-size: .875rem; } dt { color: var(--soft); } dd { margin: 0 0 .4rem; overflow-wrap: anywhere; }
dl.words { display: grid; grid-template-columns: max-content 1fr; gap: .25rem 1rem; max-width: 64rem; }
dl.words dt { font-weight: 600; color: inherit; } dl.words dd { margin: 0; }
@media screen and (max-width: 48rem) { article { grid-template-columns: minmax(0, 1fr); } dl.words { grid-template-columns: 1fr; } }
)css";

std::string cell(const std::string& text) { return "<td>" + escaped(text) + "</td>"; }

std::string heads(std::initializer_list<const char*> names) {
  return fmt::format("<th>{}</th>", fmt::join(names, "</th><th>"));
}

std::string table(const std::string& head, const std::string& body) {
  return fmt::format("<div class=\"wide\"><table><thead><tr>{}</tr></thead><tbody>\n{}</tbody></table></div>",
                     head, body);
}

std::string details(const char* summary, const std::string& inside) {
  return fmt::format("<details><summary>{}</summary>{}</details>\n", summary, inside);
}

std::string status_cell(const Cell& one) {
  return fmt::format("<td class=\"{}\" title=\"{}: {} ({} cases)\">{}</td>", text_of(one.status).style,
                     escaped(one.property->name), escaped(text_of(one.status).words), one.tally.judged(),
                     text_of(one.status).sign);
}

/// "1.6 of 2, 1.1 of 4, 0.9 of 4": point, normal and, of a triangle, coordinates; nothing where none was
/// judged.
std::string hit_figures(const Worst& worst, const HitBounds& bounds) {
  if (worst.details == 0) return "";
  const std::string text =
      figure(worst.point, bounds.point.promised) + ", " + figure(worst.normal, bounds.normal.promised);
  const bool has_coordinates = std::isfinite(bounds.coordinates.promised);
  return has_coordinates ? text + ", " + figure(worst.coordinates, bounds.coordinates.promised) : text;
}

/// "0.93 of 8" for each measure; nothing where none was taken.
std::string measured_cells(const Row& row) {
  const Contract& contract = row.subject->contract;
  const Worst& worst = row.worst;
  if (!row.is_measured()) return "<td></td><td></td><td></td><td></td><td></td>";
  return cell(fmt::format("{} of {}", worst.wrong, worst.cases)) +
         cell(figure(worst.verdict, contract.verdict.promised)) +
         cell(figure(worst.residual, contract.residual.promised)) +
         cell(figure(worst.ulp, contract.ulp.promised)) + cell(hit_figures(worst, contract.hit));
}

std::string main_table(const Summary& summary) {
  std::string head = heads({"method", "precision", "cases"});
  for (const Property& property : properties())
    head += fmt::format("<th title=\"{}\">{}</th>", escaped(property.statement), escaped(property.name));
  head += heads({"wrong verdicts, in the domain", "widest verdict band", "worst residual", "worst ulp",
                 "worst point, normal, coordinates"});
  std::string body;
  for (const Row& row : summary.rows) {
    body += fmt::format("<tr><td title=\"{}\">{}</td><td>{}</td><td>{}</td>", escaped(row.subject->title),
                        escaped(row.subject->full_name()), name_of(row.precision), row.cases);
    for (const Cell& one : row.cells) body += status_cell(one);
    body += measured_cells(row) + "</tr>\n";
  }
  std::string legend;
  for (const ClaimStatus status : statuses_in_legend)
    legend += fmt::format("<span class=\"{}\">{}</span> {} &emsp; ", text_of(status).style,
                          text_of(status).sign, escaped(text_of(status).words));
  return fmt::format("{}<p class=\"legend\">{}</p>\n{}", table(head, body), legend, page_legend);
}

std::string family_table(const RunResult& result) {
  std::string body;
  for (const Unit& unit : result.units) {
    const Worst& worst = unit.tally.worst;
    if (worst.cases > 0)
      body += fmt::format(
          "<tr><td>{}</td><td>{}</td><td class=\"text\">{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
          "<td>{}</td></tr>\n",
          escaped(unit.subject->full_name()), name_of(unit.precision), escaped(unit.family->name),
          worst.cases, worst.wrong, figure(worst.verdict), figure(worst.residual), figure(worst.ulp));
  }
  const std::string head = heads({"method", "precision", "family", "cases in domain", "wrong verdicts",
                                  "verdict band", "residual", "ulp"});
  return details("Worst errors of each method on each family", table(head, body));
}

std::string label_table(const RunResult& result) {
  std::string body;
  for (const LabelCount& labels : result.labels)
    body += fmt::format(
        "<tr><td>{}/{}</td><td>{}</td><td class=\"text\">{}</td><td class=\"text\">{}</td></tr>\n",
        escaped(labels.family->topic), escaped(labels.family->name), name_of(labels.precision),
        escaped(labels.family->description), escaped(labels.shares()));
  return details("What the families produced", table(heads({"family", "precision", "aim", "labels"}), body));
}

std::string outcome(const Summary& summary) {
  const auto [style, sentence] =
      !summary.is_success() ? std::pair{"broken", "✗ not every contract holds"}
      : summary.was_interrupted
          ? std::pair{"refuted", "– interrupted: no contract is broken by what was checked before"}
          : std::pair{"holds", "✓ every contract holds"};
  std::string text = fmt::format("<p class=\"verdict {}\">{}</p>\n", style, sentence);
  for (const std::string& failure : summary.failures()) text += "<p>✗ " + escaped(failure) + "</p>\n";
  return text;
}

/// What breaks a contract first; then what the contracts declare, method by method.
std::string all_findings(const Plan& plan, const RunResult& result, const PageTools& tools) {
  std::string failures;
  for (const Finding& finding : result.findings)
    if (!finding.is_declared) failures += html_finding(finding, tools);
  std::string declared;
  for (const Subject* subject : plan.subjects) {
    std::string of_method;
    for (const Finding& finding : result.findings)
      if (finding.is_declared && finding.subject == subject) of_method += html_finding(finding, tools);
    if (!of_method.empty())
      declared += fmt::format("<h3>{} <span class=\"soft\">{}</span></h3>\n{}", escaped(subject->full_name()),
                              escaped(subject->title), of_method);
  }
  std::string text;
  if (!failures.empty()) text += "<h2>Findings that break a contract</h2>\n" + failures;
  if (!declared.empty()) text += "<h2>Findings that the contracts declare</h2>\n" + declared;
  return text.empty() ? "<h2>Findings</h2>\n<p>None.</p>\n" : text;
}

}  // namespace

std::string html_page(const Plan& plan, const RunResult& result, const Summary& summary,
                      const PageTools& tools) {
  return html_head("rayproof check", std::string(figures_style) + check_style) +
         fmt::format(
             "</head>\n<body>\n<main>\n<h1>rayproof check</h1>\n<p class=\"soft\">Seed {}, {} cases for each "
             "method, "
             "family and precision{}; {} corpus cases.</p>\n{}<h2>Methods and what they claim</h2>\n{}{}"
             "<h2>Figures</h2>\n{}{}</main>\n</body>\n</html>\n",
             plan.settings.seed, plan.settings.cases, plan.settings.time ? " at most" : "",
             result.corpus_cases, outcome(summary), main_table(summary), all_findings(plan, result, tools),
             family_table(result), label_table(result));
}

}  // namespace rayproof
