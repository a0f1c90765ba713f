#include <fmt/format.h>
#include <fmt/ranges.h>

#include "case/escape.hpp"
#include "dossier/collection.hpp"
#include "properties/report/page_style.hpp"

namespace rayproof::dossier {
namespace {

/// A kind of fault has a sign of its own beside its colour.
constexpr const char* findings_style = R"css(
article { border: 1px solid var(--line); border-radius: 6px; padding: 1rem; margin: 0 0 1rem; break-inside: avoid;
          display: grid; grid-template-columns: minmax(0, 2fr) minmax(0, 3fr); gap: 1rem 1.5rem; }
article h3 { grid-column: 1 / -1; font-size: 1.0625rem; } article > details { grid-column: 1 / -1; margin: 0; }
th.text { text-align: left; } table { margin: 0 0 1rem; }
td.text { white-space: normal; }
.kind { border: 1px solid; border-radius: 4px; padding: 0 .4em; white-space: nowrap; font-weight: 600; }
.gross { color: var(--bad); border-width: 2px; } .protocol { color: var(--bad); border-style: dashed; } .boundary { color: var(--claimed); }
.range { color: var(--known); } .rounding { color: var(--soft); } .clean { color: var(--exact); font-weight: 600; }
dl { margin: 0; display: grid; grid-template-columns: max-content minmax(0, 1fr); gap: .25rem 1rem; font-size: .9375rem; }
dt { color: var(--soft); } dd { margin: 0; overflow-wrap: anywhere; } dd code, h3 code { overflow-wrap: anywhere; }
section { margin: 0 0 2.5rem; } nav ul { padding-left: 1.2rem; } nav li { margin: .15rem 0; }
@media screen and (max-width: 48rem) { article { grid-template-columns: minmax(0, 1fr); } dl { grid-template-columns: 1fr; } }
@media print { article { grid-template-columns: minmax(0, 1fr) minmax(0, 2fr); } details:not([open]) { display: none; } }
)css";

/// "✗ gross".
std::string kind_label(std::string_view kind) {
  const char* const sign = kind == "gross"      ? "✗"
                           : kind == "protocol" ? "⚠"
                           : kind == "boundary" ? "◐"
                           : kind == "range"    ? "↔"
                                                : "≈";
  return fmt::format("<span class=\"kind {0}\">{1} {0}</span>", kind, sign);
}

std::string entry(const char* name, const std::string& html) {
  return html.empty() ? "" : fmt::format("<dt>{}</dt><dd>{}</dd>", name, html);
}

std::string code(const std::string& text) { return "<code>" + escaped(text) + "</code>"; }

/// What the library was asked and said, and what is right, where it could be asked again.
std::string confirmed(const FiledFinding& filed) {
  const Dossier& dossier = filed.dossier;
  if (!filed.trouble.empty()) return entry("Not asked again", escaped(filed.trouble));
  std::string steps;
  for (const std::string& step : dossier.right.steps) steps += escaped(step) + "<br>";
  return entry("Asked", code(numbers_in_words(dossier.reproduction.inputs))) +
         entry("It said", dossier.reproduction.has_returned
                              ? code(dossier.reproduction.printed)
                              : escaped("no answer: " + dossier.reproduction.ending)) +
         entry("Right is", escaped(dossier.comparison.expected)) + entry("By hand", steps);
}

std::string article(const FiledFinding& filed, const DrawCase& draw) {
  const RecordedFinding& recorded = filed.recorded();
  const Finding& finding = recorded.finding;
  const bool is_confirmed = filed.trouble.empty() && filed.dossier.objection.empty();
  const std::string about =
      is_confirmed ? filed.dossier.title() : recorded.shape + "/" + recorded.name + " " + recorded.says;
  std::string text = fmt::format(
      "<article id=\"finding-{0}\"><h3>{0}. {1} <span "
      "class=\"soft\">{9}</span></h3><figure>{2}</figure><dl>{3}{4}{5}{6}{7}{8}</dl>",
      finding.number, escaped(about), picture_of(filed, draw),
      entry("Kind", kind_label(recorded.kind) + " " + where_seen(finding)),
      entry("Found", escaped(recorded.says)) + entry("Also in", escaped(also_in_words(filed))),
      confirmed(filed),
      entry("Diagnosis", escaped(finding.diagnosis.empty() ? "none: there is no answer" : finding.diagnosis)),
      entry("Documentation", escaped(documentation_of(filed))),
      entry("Not to be filed", escaped(filed.dossier.objection)), escaped(recorded.name));
  if (is_confirmed)
    text += fmt::format(
        "<details><summary>Report and reproduction: rayproof bugreport {}</summary><pre>{}</pre></details>",
        finding.number, escaped(bug_report(filed.dossier)));
  return text + "</article>\n";
}

/// What was judged of each subject and shape.
std::string judged_html(const LibraryDossier& library) {
  std::string rows;
  for (const JudgedShape& one : library.judged) {
    std::vector<std::string> claims, found;
    for (const auto& [claim, count] : one.claims) claims.push_back(fmt::format("{} {}", claim, count));
    for (const FiledFinding& filed : library.findings)
      if (filed.is_of(one))
        found.push_back(fmt::format("<a href=\"#finding-{0}\">{0}</a>", filed.recorded().finding.number));
    rows += fmt::format(
        "<tr><th>{}</th><td class=\"text\">{}</td><td>{}</td><td>{}</td><td>{}</td><td class=\"text\">{}</td>"
        "<td class=\"text\">{}</td></tr>\n",
        one.name, one.shape, one.answered(), one.unsupported, one.failures, fmt::join(claims, ", "),
        found.empty() ? "<span class=\"clean\">✓ nothing found</span>"
                      : fmt::format("{}", fmt::join(found, ", ")));
  }
  return "<div class=\"wide\"><table><thead><tr><th>subject</th><th "
         "class=\"text\">shape</th><th>answered</th><th>excluded</th>"
         "<th>no answer</th><th class=\"text\">judged, on how many cases</th><th "
         "class=\"text\">findings</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>\n";
}

std::string section(const LibraryDossier& library, const DrawCase& draw) {
  std::string text = fmt::format("<section id=\"{0}\"><h2>{0} {1}</h2>\n{2}", escaped(library.facts.name),
                                 escaped(library.facts.version), judged_html(library));
  for (const FiledFinding& filed : library.findings) text += article(filed, draw);
  return text + "</section>\n";
}

/// A line for each library.
std::string contents(const std::vector<LibraryDossier>& libraries) {
  std::string lines;
  for (const LibraryDossier& library : libraries) {
    std::vector<std::string> kinds;
    for (const std::string_view kind : kind_names) {
      const auto count = std::ranges::count_if(
          library.findings, [&](const FiledFinding& one) { return one.recorded().kind == kind; });
      if (count > 0) kinds.push_back(fmt::format("{} {}", count, kind_label(kind)));
    }
    lines += fmt::format("<li><a href=\"#{0}\">{0} {1}</a>: {2}</li>\n", escaped(library.facts.name),
                         escaped(library.facts.version),
                         kinds.empty() ? "<span class=\"clean\">✓ nothing found</span>"
                                       : fmt::format("{}", fmt::join(kinds, ", ")));
  }
  return "<nav><ul>\n" + lines + "</ul></nav>\n";
}

}  // namespace

std::string findings_page(const std::vector<LibraryDossier>& libraries, const PageTools& tools) {
  std::string text =
      html_head("Findings in other people's libraries",
                std::string(figures_style) + findings_style + tools.style) +
      fmt::format(
          "</head>\n<body>\n<main>\n<h1>Findings in other people's libraries</h1>\n<p class=\"soft\">{}. "
          "What a library's documentation excludes is counted and not judged.</p>\n{}",
          escaped(budget_in_words(libraries)), contents(libraries));
  for (const LibraryDossier& library : libraries) text += section(library, tools.draw);
  return text + html_end(tools.script);
}

}  // namespace rayproof::dossier
