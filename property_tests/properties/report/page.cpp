#include "properties/report/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "case/escape.hpp"
#include "properties/report/guest.hpp"
#include "properties/report/page_style.hpp"
#include "properties/report/page_tables.hpp"

namespace rayproof {

namespace {

/// Marks differ in sign and border as well as in colour.
constexpr const char* check_style = R"css(
td.mark { text-align: center; font-weight: 600; } th.claim span { writing-mode: vertical-rl; rotate: 180deg; white-space: nowrap; }
.holds { color: var(--exact); } .refuted { color: var(--known); } .broken { color: var(--bad); }
.mark.refuted { outline: 1px dashed; outline-offset: -4px; } .mark.broken { outline: 2px solid; outline-offset: -3px; }
p.legend { font-size: .875rem; } p.legend > span { white-space: nowrap; margin-right: 1.5em; }
p.legend span span { display: inline-block; min-width: 1.6em; text-align: center; }
article { border: 1px solid var(--line); border-radius: 6px; padding: 1rem; margin: 0 0 1rem; break-inside: avoid;
          display: grid; grid-template-columns: minmax(0, 3fr) minmax(0, 2fr); gap: 1rem 1.5rem; }
article.declared { border-style: dashed; }
.number { border: 1px solid; border-radius: 4px; padding: 0 .35em; margin-right: .25em; } p.words { font-size: 1.0625rem; }
dl { margin: .5rem 0 0; font-size: .875rem; } dt { color: var(--soft); } dd { margin: 0 0 .4rem; overflow-wrap: anywhere; }
dl.words { display: grid; grid-template-columns: max-content 1fr; gap: .25rem 1rem; max-width: 64rem; }
dl.words dt { font-weight: 600; color: inherit; } dl.words dd { margin: 0; }
@media screen and (max-width: 48rem) { article { grid-template-columns: minmax(0, 1fr); } dl.words { grid-template-columns: 1fr; } }
)css";

/// Paper shows what is folded on the screen.
constexpr const char* open_when_printed =
    R"html(<script>addEventListener("beforeprint", () => document.querySelectorAll("details").forEach((one) => { one.open = true; }));</script>
)html";

bool is_of_programs(const Plan& plan) {
  return !plan.subjects.empty() && std::ranges::none_of(plan.subjects, &Subject::has_own_contract);
}

/// What is said of programs and of methods in the same places.
struct PageWords {
  const char* each;      ///< what each number of cases is for
  const char* claims;    ///< the heading of the table of claims
  const char* errors;    ///< the heading of the table of errors
  const char* findings;  ///< the heading of the findings
};
constexpr PageWords of_methods{"method", "Methods and what they claim", "Worst errors of each method",
                               "Findings that break a contract"};
constexpr PageWords of_programs{"shape", "What is expected of the program", "Worst errors on each shape",
                                "Findings"};

/// "a clean bill", or how many findings of which kind.
std::string outcome_of_programs(const Plan& plan, const RunResult& result) {
  const GuestVerdict verdict = verdict_on_guests(plan, result);
  return fmt::format("<p class=\"verdict {}\">{} {}</p>\n", verdict.is_clean ? "holds" : "broken",
                     verdict.is_clean ? "✓" : "✗", escaped(verdict.sentence));
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

std::string findings_that_break(const RunResult& result, const PageTools& tools, const PageWords& words) {
  std::string all;
  for (const Finding& finding : result.findings)
    if (!finding.is_declared) all += html_finding(finding, tools);
  return all.empty() ? all : fmt::format("<h2>{}</h2>\n", words.findings) + all;
}

/// Method by method.
std::string declared_findings(const Plan& plan, const RunResult& result, const PageTools& tools) {
  std::string all;
  for (const Subject* subject : plan.subjects) {
    std::string of_method;
    for (const Finding& finding : result.findings)
      if (finding.is_declared && finding.subject == subject) of_method += html_finding(finding, tools);
    if (!of_method.empty())
      all += fmt::format("<h3>{} <span class=\"soft\">{}</span></h3>\n{}", escaped(subject->full_name()),
                         escaped(subject->title), of_method);
  }
  return all.empty() ? all : "<h2>Findings that the contracts declare</h2>\n" + all;
}

}  // namespace

std::string html_page(const Plan& plan, const RunResult& result, const Summary& summary,
                      const PageTools& tools) {
  const bool is_guests = is_of_programs(plan);
  const PageWords& words = is_guests ? of_programs : of_methods;
  const std::string how_many = fmt::format(
      "<p class=\"soft\">Seed {}, {} cases for each {}, family and precision{}; {} corpus cases.</p>\n",
      plan.settings.seed, plan.settings.cases, words.each, plan.settings.time ? " at most" : "",
      result.corpus_cases);
  // What is wrong comes first, before what was asked and how it was measured.
  return html_head("rayproof check", std::string(figures_style) + check_style + tools.style) +
         "</head>\n<body>\n<main>\n<h1>rayproof check</h1>\n" + how_many +
         (is_guests ? outcome_of_programs(plan, result) : outcome(summary)) +
         findings_that_break(result, tools, words) +
         fmt::format("<h2>{}</h2>\n{}<h2>{}</h2>\n{}", words.claims, claims_table(summary), words.errors,
                     errors_table(summary)) +
         declared_findings(plan, result, tools) + "<h2>Figures</h2>\n" + family_table(result) +
         label_table(result) + open_when_printed + html_end(tools.script);
}

}  // namespace rayproof
