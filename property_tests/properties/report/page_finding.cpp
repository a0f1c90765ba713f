#include "properties/report/report.hpp"

#include <fmt/format.h>

#include "case/escape.hpp"
#include "case/writer.hpp"
#include "properties/engine/kind.hpp"
#include "properties/report/findings.hpp"

namespace rayproof {

namespace {

std::string error_in_words(const Evidence& evidence) {
  return evidence.error_ulp ? figure(*evidence.error_ulp) + " ulp"
                            : "the verdict itself is wrong, or nothing was promised";
}

/// What the picture shows of the answer: nothing where there is none, or it has no t.
const Answer* shown_answer(const Evidence& evidence) {
  const auto* hits = std::get_if<RayAnswer>(&evidence.got);
  const bool is_bare = hits != nullptr && hits->verdict_only;
  return evidence.no_answer.empty() && !is_bare ? &evidence.got : nullptr;
}

/// An answer's line of JSON, without the id.
std::string answer_line(const Finding& finding, const Answer& answer) {
  Case bare = finding.one;
  bare.id.clear();
  if (&answer == &finding.evidence.got && !finding.evidence.no_answer.empty()) return "no answer";
  return write_answer(bare, answer);
}

std::string because(const Finding& finding) {
  const Refutation* const declared = declared_refutation(*finding.subject, *finding.property);
  return declared != nullptr ? fmt::format("<p>Declared: {}.</p>", escaped(declared->because)) : "";
}

/// What the diagnosis has found out, as entries of a list.
std::string diagnosis_of(const Finding& finding) {
  if (finding.diagnosis.empty()) return "";
  return fmt::format("<dt>Diagnosis</dt><dd>{}: {} ({} {})</dd>", name_of(kind_of(finding)),
                     escaped(finding.diagnosis), finding.cases, finding.cases == 1 ? "case" : "cases");
}

/// The commands that look into the finding, one a line.
std::string commands_for(const Finding& finding, const std::filesystem::path& folder) {
  std::string lines;
  for (const char* const command : {"explain", "walk", "draw", "replay"})
    lines += fmt::format("./rayproof {} {}{}\n", command, finding.number, from_option(folder));
  return lines;
}

}  // namespace

std::string html_finding(const Finding& finding, const PageTools& tools) {
  const Evidence& evidence = finding.evidence;
  return fmt::format(
      R"(<article id="finding-{0}" class="{1}"><div><figure>{2}</figure></div><div>
<h3><span class="number">{0}</span> {3} <span class="soft">{4}</span></h3>
<p class="words">{5}</p><p>{6}: {7}. <span class="soft">({8})</span></p>{9}
<dl>{17}<dt>Measured</dt><dd>{10}</dd><dt>Error</dt><dd>{11}</dd><dt>Found in family</dt><dd>{12}</dd></dl>
</div><div style="grid-column: 1 / -1"><pre class="commands">{13}</pre>
<details><summary>The case and both answers</summary><pre>{14}
got   {15}
exact {16}</pre></details></div></article>
)",
      finding.number, finding.is_declared ? "declared" : "undeclared",
      tools.draw(finding.one, &evidence.exact, shown_answer(evidence)), escaped(finding.subject->full_name()),
      name_of(finding.one.precision), escaped(in_words(finding)),
      finding.is_declared ? "‡ breaks, as declared" : "✗ BREAKS", escaped(finding.property->statement),
      escaped(finding.property->name), because(finding), escaped(evidence.note),
      escaped(error_in_words(evidence)), escaped(finding.family),
      escaped(commands_for(finding, tools.folder)), escaped(write_case(finding.one)),
      escaped(answer_line(finding, evidence.got)), escaped(answer_line(finding, evidence.exact)),
      diagnosis_of(finding));
}

}  // namespace rayproof
