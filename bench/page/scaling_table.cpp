#include <fmt/format.h>

#include <algorithm>

#include "bench/figures/curve.hpp"
#include "bench/figures/options.hpp"
#include "bench/page/scaling_svg.hpp"
#include "bench/page/text.hpp"
#include "case/escape.hpp"

namespace rayproof::report {

namespace {

std::string quartiles(const CurvePoint& point) {
  return fmt::format("<td>{}<br><span class=\"soft\">{}–{}</span></td>", nanoseconds(point.ns),
                     nanoseconds(point.low), nanoseconds(point.high));
}

/// All sizes of a chart, ascending.
std::vector<std::size_t> sizes_of(const CurveChart& chart) {
  std::vector<std::size_t> sizes;
  for (const CurveLine& line : chart.lines)
    for (const CurvePoint& point : line.points) sizes.push_back(point.size);
  std::ranges::sort(sizes);
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  return sizes;
}

const CurvePoint* point_at(const CurveLine& line, std::size_t size) {
  const auto found = std::ranges::find(line.points, size, &CurvePoint::size);
  return found == line.points.end() ? nullptr : &*found;
}

std::string table_in_html(const CurveChart& chart, const char* sizes) {
  std::string head, body;
  for (const CurveLine& line : chart.lines) head += "<th>" + escaped(line.name) + "</th>";
  for (const std::size_t size : sizes_of(chart)) {
    body += fmt::format("<tr><td>{}</td>", size);
    for (const CurveLine& line : chart.lines) {
      const CurvePoint* const point = point_at(line, size);
      body += point == nullptr ? "<td>–</td>" : quartiles(*point);
    }
    body += "</tr>\n";
  }
  return fmt::format(
      "<section><h3>{}</h3><div class=\"wide\"><table><thead><tr><th>{}</th>{}</tr></thead><tbody>\n{}"
      "</tbody></table></div></section>\n",
      escaped(chart.title), sizes, head, body);
}

}  // namespace

std::string scaling_in_html(const std::vector<BenchRow>& rows) {
  std::string html;
  for (const char* const curve : scaling_names) {
    const std::vector<CurveChart> charts = charts_of(rows, curve);
    if (charts.empty()) continue;
    const CurveWords words = words_on(curve);
    html +=
        fmt::format("<h2 id=\"{}\">{}</h2>\n<p>{}{} Medians, below them the quartiles of the passes.</p>\n",
                    curve, words.title, words.note, lack_of(charts, curve));
    html += "<figure>" + scaling_in_svg(rows, curve) + "</figure>\n";
    for (const CurveChart& chart : charts) html += table_in_html(chart, words.sizes);
  }
  return html;
}

std::string scaling_in_text(const std::vector<BenchRow>& rows) {
  std::string text;
  for (const char* const curve : scaling_names)
    for (const CurveChart& chart : charts_of(rows, curve)) {
      const CurveWords words = words_on(curve);
      text += fmt::format("\n{}, {}: ns a ray\n{:>9}", words.title, chart.title, words.sizes);
      for (const CurveLine& line : chart.lines) text += fmt::format(" {:>22}", line.name);
      text += '\n';
      for (const std::size_t size : sizes_of(chart)) {
        text += fmt::format("{:>9}", size);
        for (const CurveLine& line : chart.lines) {
          const CurvePoint* const point = point_at(line, size);
          text += fmt::format(" {:>22}", point == nullptr ? "-" : nanoseconds(point->ns));
        }
        text += '\n';
      }
    }
  return text;
}

}  // namespace rayproof::report
