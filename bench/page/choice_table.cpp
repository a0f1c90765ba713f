#include "bench/page/choice_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/page/svg.hpp"
#include "bench/page/text.hpp"

namespace rayproof::report {

namespace {

constexpr const char* words_on_choices =
    "Sound methods by the figures of this run; batches where the shape has them, else one ray at a time. "
    "Closest: the fewest wrong verdicts, then the fewest bits of error, at up to twice the price of the "
    "fastest.";

/// "0.73 ns, 0.01 % wrong".
std::string figures_of(const MethodSummary& one) {
  const std::string wrong =
      one.wrong_share() == 0 ? "none wrong" : figure(100 * one.wrong_share()) + " % wrong";
  return figure(one.ns_per_ray) + " ns, " + wrong;
}

std::string in_text(const MethodSummary& one) { return fmt::format("{} {}", one.method, figures_of(one)); }

std::string in_html(const MethodSummary& one) {
  return fmt::format("<td class=\"text\"><b>{}</b> {}<br><span class=\"soft\">{}</span></td>",
                     escaped(one.method), figures_of(one), escaped(guarantee_of(one)));
}

/// By itself, on a page or on paper; in the page's colours or on a dark screen.
constexpr const char* price_style = R"css(<style>
.price { font: 14px system-ui, sans-serif; fill: #1a1a1a; --paper: #ffffff; --soft: #59636e; --line: #d0d7de; }
@media screen and (prefers-color-scheme: dark) { .price { fill: #e6edf3; --paper: #14181d; --soft: #9aa4af; --line: #3a424c; } }
.price .title { font-weight: 600; } .price .soft { fill: var(--soft); } .price .grid { stroke: var(--line); stroke-width: .6; }
.price .way { stroke: currentColor; stroke-width: 1.2; stroke-dasharray: 1.5 3; } .price { color: var(--soft); }
.price .fastest { fill: var(--paper); stroke: #0072b2; stroke-width: 2; } .price .exact { fill: #b84a00; }
.price .oracle { fill: var(--paper); stroke: #00734f; stroke-width: 2; }
@media screen and (prefers-color-scheme: dark) { .price .fastest { stroke: #56b4e9; } .price .exact { fill: #ff8f4d; } .price .oracle { stroke: #2fc99a; } }
</style>
)css";

/// "3.3", "17", "2300".
std::string rounded_ratio(double ratio) {
  const double power = std::pow(10, std::max(0.0, std::floor(std::log10(ratio)) - 1));
  return ratio < 10 ? fmt::format("{:.1f}", ratio) : fmt::format("{:.0f}", std::round(ratio / power) * power);
}

/// Places of the plot of costs.
struct CostAxis {
  static constexpr double left = 210, width = 640, row = 30, top = 56;
  double low = 10, high = -10;  ///< log10 of nanoseconds

  void include(double ns) {
    low = std::min(low, std::log10(ns));
    high = std::max(high, std::log10(ns));
  }
  [[nodiscard]] double x(double ns) const {
    // Room for a method's name on either side.
    return left + width * (0.2 + 0.6 * (std::log10(ns) - low) / std::max(high - low, 0.1));
  }
};

std::string ticks(const CostAxis& axis, double bottom) {
  std::string svg;
  for (int power = -2; power <= 5; ++power) {
    const double x = axis.x(std::pow(10, power));
    if (x < CostAxis::left || x > CostAxis::left + CostAxis::width) continue;
    svg += svg_line(x, CostAxis::top, x, bottom, "grid");
    svg += svg_text(x, bottom + 18, "middle", fmt::format("{:g}", std::pow(10, power)));
  }
  return svg + svg_text(CostAxis::left + CostAxis::width / 2, bottom + 40, "middle", "nanoseconds a ray",
                        "class=\"soft\"");
}

/// The exact method's name: to the right of its mark; where the oracle's would lie on it, above.
std::string label_of_exact(const Choice& one, const CostAxis& axis, double y, const std::string& label) {
  constexpr double letter = 8, half_mark = 7, gap = 12;
  const double exact = axis.x(one.exact->ns_per_ray);
  const double oracle = one.oracle_ns ? axis.x(*one.oracle_ns) : -infinity<double>;
  const double end = exact + gap + letter * static_cast<double>(label.size());
  if (oracle + half_mark < exact || oracle - half_mark > end)
    return svg_text(exact + gap, y + 5, "start", label);
  return svg_text(exact + half_mark, y - 9, "end", label);
}

/// A hollow circle for the fastest, its name to the left; a solid square for the exact one, to the right.
std::string costs_of(const Choice& one, const CostAxis& axis, double y) {
  const double fast = axis.x(one.fastest.ns_per_ray);
  std::string svg = svg_text(CostAxis::left - 10, y + 5, "end",
                             fmt::format("{} {}", one.fastest.shape, name_of(one.fastest.precision)));
  const bool is_one = one.exact && one.exact->method == one.fastest.method;
  if (one.oracle_ns)
    svg += fmt::format(
        "<path class=\"oracle\" d=\"M{:.1f} {:.1f}l7 7 7 -7 -7 -7z\"><title>oracle {} ns</title></path>\n",
        axis.x(*one.oracle_ns) - 7, y, figure(*one.oracle_ns));
  if (one.exact) {
    const double exact = axis.x(one.exact->ns_per_ray);
    svg += svg_line(fast, y, exact, y, "way");
    svg += fmt::format(
        "<rect class=\"exact\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"12\" "
        "height=\"12\"><title>{}</title></rect>\n",
        exact - 6, y - 6, escaped(in_text(*one.exact)));
    const std::string multiple =
        is_one ? "" : " ×" + rounded_ratio(one.exact->ns_per_ray / one.fastest.ns_per_ray);
    svg += label_of_exact(one, axis, y, one.exact->method + multiple);
  }
  if (is_one) return svg;
  return svg +
         fmt::format(
             "<circle class=\"fastest\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"6\"><title>{}</title></circle>\n",
             fast, y, escaped(in_text(one.fastest))) +
         svg_text(fast - 12, y + 5, "end", one.fastest.method);
}

}  // namespace

std::string choices_in_text(const std::vector<Choice>& choices) {
  std::string text = fmt::format("Which method?\n{:<16} {:<7} {:<11}  {:<40} {:<40} {}\n", "shape", "",
                                 "scenes", "fastest", "closest", "exact");
  for (const Choice& one : choices)
    text += fmt::format("{:<16} {:<7} {:<11}  {:<40} {:<40} {}\n", one.fastest.shape,
                        name_of(one.fastest.precision), name_of(one.scenes), in_text(one.fastest),
                        in_text(one.closest), one.exact ? in_text(*one.exact) : "-");
  return text + words_on_choices + "\n";
}

std::string choices_in_html(const std::vector<Choice>& choices) {
  std::string html = fmt::format(
      "<h2 id=\"choice\">Which method do I take?</h2>\n<p>{}</p>\n<div class=\"wide\"><table><thead><tr>"
      "<th>shape</th><th>precision</th><th>scenes</th><th>fastest</th><th>closest</th><th>exact</th></tr>"
      "</thead><tbody>\n",
      words_on_choices);
  for (const Choice& one : choices)
    html += fmt::format(
        "<tr><td class=\"text\">{}</td><td class=\"text\">{}</td><td class=\"text\">{}</td>{}{}{}</tr>\n",
        escaped(one.fastest.shape), name_of(one.fastest.precision), name_of(one.scenes), in_html(one.fastest),
        in_html(one.closest), one.exact ? in_html(*one.exact) : "<td>-</td>");
  return html + "</tbody></table></div>\n";
}

std::string choices_in_svg(const std::vector<Choice>& choices) {
  CostAxis axis;
  std::size_t rows = 0;
  for (const Choice& one : choices) {
    if (one.scenes != Scenes::near_by) continue;
    ++rows;
    axis.include(one.fastest.ns_per_ray);
    if (one.exact) axis.include(one.exact->ns_per_ray);
    if (one.oracle_ns) axis.include(*one.oracle_ns);
  }
  if (rows == 0) return "";
  const double bottom = CostAxis::top + CostAxis::row * static_cast<double>(rows);
  std::string svg = fmt::format(
      "<svg class=\"price\" viewBox=\"0 0 900 {:.0f}\" role=\"img\" xmlns=\"http://www.w3.org/2000/svg\">\n"
      "<title>The price of an exact answer</title>\n{}",
      bottom + 50, price_style);
  svg += svg_text(0, 18, "start", "The price of an exact answer, for random scenes", "class=\"title\"");
  svg += svg_text(0, 40, "start",
                  "○ the fastest sound method   ■ the fastest exact one, and how many times as long it takes "
                  "  ◇ one exact "
                  "verdict of the oracle");
  svg += ticks(axis, bottom);
  double y = CostAxis::top + CostAxis::row / 2;
  for (const Choice& one : choices) {
    if (one.scenes != Scenes::near_by) continue;
    svg += costs_of(one, axis, y);
    y += CostAxis::row;
  }
  return svg + "</svg>\n";
}

}  // namespace rayproof::report
