#include "bench/page/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bench/page/choice_table.hpp"
#include "bench/page/comparison_table.hpp"
#include "bench/page/plot_svg.hpp"
#include "bench/page/scaling_svg.hpp"
#include "bench/page/text.hpp"
#include "case/escape.hpp"
#include "generators/generators.hpp"
#include "properties/report/page_style.hpp"

namespace rayproof::report {

namespace {

constexpr const char* plot_style = R"css(
.plot { font: 14px system-ui, sans-serif; fill: var(--ink); }
.plot .title { font-weight: 600; } .plot .note, .plot .axis { fill: var(--soft); }
.plot .frame { fill: none; stroke: var(--ink); } .plot .grid { stroke: var(--line); stroke-width: .6; }
.plot .floor { stroke: var(--soft); stroke-width: 1.6; stroke-dasharray: 6 4; }
.plot .oracle { stroke: var(--exact); stroke-width: 1.6; stroke-dasharray: 12 3 2 3; } .plot .name { stroke: var(--paper); stroke-width: 3; paint-order: stroke; }
.plot .front { fill: none; stroke: var(--ink); stroke-width: 1.2; stroke-dasharray: 1.5 3; }
.plot .solid { fill: var(--m); stroke: var(--m); stroke-width: 2; } .plot .solid .in { stroke: var(--paper); }
.plot .halo { fill: var(--paper); stroke: none; }
.plot .hollow { fill: var(--paper); stroke: var(--m); stroke-width: 2; }
tr.floor td { color: var(--soft); } section { break-inside: avoid-page; margin-top: 1.5rem; } figure { break-inside: avoid; }
)css";

constexpr const char* how_to_read = R"html(
<p>Every mark is one method over the families of scenes: hollow one ray at a time, solid in batches. Left is faster, down is more
accurate; the dotted stair is the Pareto front, the dashed line what merely reading the rays and writing the answers costs, the dashed and dotted one what the oracle does, one exact verdict on each. Triangles are other
people's libraries.</p>
<p class="soft">The families bit_patterns, exponents and special, in which everything over- and underflows, are left out of the
plots and the first tables; their own tables stand below. Wrong verdicts are cases with a hit too many or too few by the exact oracle. Bits of error are
log₂(1 + floats between the hit and the correctly rounded one), averaged over the hits that method and oracle agree on; wrong
verdicts are never averaged in. Point, normal and coordinates are the worst errors of the first hit's in contract units,
about one rounding each; a normal on the wrong side is off by 10⁷ of them in float, 10¹⁶ in double. Times are processor time, medians over families of median passes. For timing, each case's ray is moved
with its shape by an affine map until all lie at one shape, as a batch needs. GLM reports only the nearest hit beyond 0, so it is judged on rays
with the interval [0, ∞], and so are the other libraries, on fewer cases (the column says how many), those that they take; it asks for unit directions, which it
was given beforehand, as VTK was the ends of its segments, except under a transform, where that can only be done for each ray anew. Embree's batch is rtcIntersect16,
the rays' arrangement into its packets included.</p>
)html";

std::string error_cells(const Accuracy& errors, bool has_errors) {
  if (!has_errors) return "<td></td><td></td><td></td><td></td><td></td><td></td><td></td><td></td><td></td>";
  return fmt::format(
      "<td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>",
      errors.cases, errors.wrong_hits, errors.wrong_misses, figure(errors.max_ulp), figure(errors.p99_ulp),
      figure(errors.mean_bits), figure(errors.max_point), figure(errors.max_normal),
      figure(errors.max_coordinates));
}

/// A row of a summary or of a family: both have the same members.
template <class Line>
std::string table_row(const Line& one) {
  return fmt::format(
      "<tr{}><td>{}</td><td class=\"text\">{}</td><td class=\"text\">{}</td><td>{}</td>{}</tr>\n",
      one.has_errors() ? "" : " class=\"floor\"", escaped(one.method), name_of(one.precision),
      name_of(one.arrangement), figure(one.ns_per_ray), error_cells(one.accuracy, one.has_errors()));
}

template <class Lines, class Wanted>
std::string table(const Lines& lines, const Wanted& is_wanted) {
  std::string body;
  for (const auto& one : lines) {
    if (is_wanted(one)) body += table_row(one);
  }
  return "<div class=\"wide\"><table><thead><tr><th>method</th><th>precision</th><th>arrangement</th><th>ns "
         "a ray</th>"
         "<th>cases</th><th>wrong hits</th><th>wrong misses</th><th>max ulp</th><th>p99 ulp</th><th>mean "
         "bits</th><th>point</th><th>normal</th><th>coordinates</th></tr>"
         "</thead><tbody>\n" +
         body + "</tbody></table></div>\n";
}

std::string families_of(const Measurements& figures, const std::string& shape) {
  std::string html;
  for (const Family& family : families()) {
    const auto is_own = [&](const BenchRow& row) { return row.shape == shape && row.family == family.name; };
    if (family.topic != shape || std::ranges::none_of(figures.rows, is_own)) continue;
    html += fmt::format("<section><h3>{}/{}</h3><p class=\"soft\">{}</p>{}</section>\n", escaped(shape),
                        escaped(family.name), escaped(family.description), table(figures.rows, is_own));
  }
  return html;
}

}  // namespace

std::string to_page(const Conclusions& found) {
  const auto& [figures, summaries, choices, plots, baseline] = found;
  std::string body =
      fmt::format("<h1>rayproof report: speed against error</h1><p class=\"soft\">{}; {}</p>\n",
                  escaped(figures.machine), escaped(figures.compiler));
  if (const auto of_sphere = headline(figures.rows))
    body += "<p class=\"verdict\">" + escaped(sentence(*of_sphere, figures.rays)) + "</p>\n";
  if (const std::string svg = choices_in_svg(choices); !svg.empty())
    body += "<figure>" + svg + "</figure>\n<p><a href=\"#choice\">Which method do I take?</a></p>\n";
  if (baseline) body += comparison_in_html(baseline->first, baseline->second);
  body += how_to_read;
  for (const Plot& plot : plots) {
    body += fmt::format("<h2>{}</h2>\n<figure>{}</figure>\n<h3>Over the families of scenes</h3>\n",
                        escaped(plot.shape), to_svg(plot));
    body += table(summaries, [&](const MethodSummary& one) { return one.shape == plot.shape; });
    body += families_of(figures, plot.shape);
  }
  body += scaling_in_html(figures.scaling);
  if (!choices.empty()) body += choices_in_html(choices);
  return html_head("rayproof report", std::string(figures_style) + plot_style) + "</head>\n<body>\n<main>\n" +
         body + "</main>\n</body>\n</html>\n";
}

}  // namespace rayproof::report
