#include "properties/report/page_finding.hpp"

#include <fmt/format.h>

#include "case/number_text.hpp"
#include "case/writer.hpp"
#include "properties/answers.hpp"
#include "properties/report/commands.hpp"
#include "properties/report/escape.hpp"

namespace rayproof {

namespace {

/// "hit at t = 4, 6", "miss", "two roots: 1, 2".
std::string in_words(const Answer& answer) {
  std::string list;
  for (const double x : numbers_in(answer)) {
    if (!list.empty()) list += ", ";
    append_number(list, x);
  }
  if (const auto* position = std::get_if<Position>(&answer)) return name_of(*position);
  if (std::holds_alternative<RayAnswer>(answer)) return list.empty() ? "miss" : "hit at t = " + list;
  return list.empty() ? "no root" : "roots " + list;
}

std::string error_in_words(const Evidence& evidence) {
  return evidence.error_ulp ? figure(*evidence.error_ulp) + " ulp"
                            : "the verdict itself is wrong, or nothing was promised";
}

/// The commands that look into the case.
std::string commands(const Finding& finding) {
  return fmt::format(
      "./rayproof explain {0} --method {1}\n./rayproof draw {0} --method {1} --html case.html\n"
      "echo {0} > case.jsonl && ./rayproof check --replay case.jsonl",
      quoted_case(finding), finding.subject->full_name());
}

std::string because(const Finding& finding) {
  for (const Refutation& refutation : finding.subject->contract.refuted)
    if (!refutation.because.empty() && refutation.claim == finding.property->claim)
      return fmt::format("<p>Declared: {}.</p>", escaped(refutation.because));
  return "";
}

}  // namespace

std::string html_finding(const Finding& finding, const DrawCase& draw) {
  const Evidence& evidence = finding.evidence;
  const char* const state = finding.is_declared ? "‡ refuted as declared" : "✗ BROKEN";
  return fmt::format(
      R"(<article class="{}"><div><figure>{}</figure></div><div>
<h3>{} <span class="faint">{}</span></h3>
<p>{}: {}</p>{}<p>{}.</p>
<dl><dt>Answer</dt><dd>{}</dd><dt>Exact</dt><dd>{}</dd><dt>Error</dt><dd>{}</dd><dt>Found in</dt><dd>{}</dd></dl>
</div><div style="grid-column: 1 / -1"><pre>{}</pre>
<p>Walk it step by step:</p><pre>{}</pre>
<details><summary>Explain, draw, replay</summary><pre>{}</pre></details></div></article>
)",
      finding.is_declared ? "declared" : "undeclared", draw(finding.one, &evidence.exact, &evidence.got),
      escaped(finding.subject->full_name()), name_of(finding.one.precision), state,
      escaped(finding.property->statement), because(finding), escaped(evidence.note),
      escaped(in_words(evidence.got)), escaped(in_words(evidence.exact)), escaped(error_in_words(evidence)),
      escaped(finding.family), escaped(write_case(finding.one)), escaped(walk_command(finding)),
      escaped(commands(finding)));
}

}  // namespace rayproof
