#include "bench/page/scaling_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include "bench/figures/curve.hpp"
#include "bench/page/svg.hpp"
#include "bench/page/text.hpp"

namespace rayproof::report {

namespace {

constexpr double frame_width = 330, frame_height = 260, chart_left = 66, chart_top = 92, room_for_names = 130,
                 chart_gap = 100;
constexpr double chart_width = chart_left + frame_width + room_for_names;

/// By itself or on a page, in its colours. Lines differ in colour, in dashes, and in the outline of their
/// marks.
constexpr const char* scaling_style = R"css(<style>
.scaling { font: 15px system-ui, sans-serif; fill: #16181c; --ink: #16181c; --paper: #ffffff; --soft: #5a626c; --line: #d0d7de; --c0: #0072b2; --c1: #b84a00; --c2: #00734f; --c3: #9c4a7f; --c4: #5a5a00; }
@media screen and (prefers-color-scheme: dark) { .scaling { fill: #e8eaed; --ink: #e8eaed; --paper: #16181c; --soft: #a3abb5; --line: #3a404a; --c0: #56b4e9; --c1: #ff8f4d; --c2: #2fc99a; --c3: #e29ac6; --c4: #d6ce4a; } }
.scaling .paper { fill: var(--paper); } .scaling .title { font-weight: 600; } .scaling .soft { fill: var(--soft); }
.scaling .grid { stroke: var(--line); stroke-width: .8; } .scaling .frame { fill: none; stroke: var(--soft); }
.scaling .l0 { --m: var(--c0); } .scaling .l1 { --m: var(--c1); } .scaling .l2 { --m: var(--c2); } .scaling .l3 { --m: var(--c3); } .scaling .l4 { --m: var(--c4); }
.scaling .path, .scaling .leader { fill: none; stroke: var(--m); stroke-width: 2; } .scaling .leader { stroke-width: 1; }
.scaling .l1 .path { stroke-dasharray: 9 4; } .scaling .l2 .path { stroke-dasharray: 2 3; } .scaling .l3 .path { stroke-dasharray: 10 3 2 3; } .scaling .l4 .path { stroke-dasharray: 6 2; }
.scaling .spread { stroke: var(--m); stroke-width: 5; opacity: .35; } .scaling .mark { fill: var(--paper); stroke: var(--m); stroke-width: 2; }
.scaling .l0 .mark, .scaling .l2 .mark { fill: var(--m); } .scaling .label { fill: var(--m); font-weight: 600; stroke: var(--paper); stroke-width: 4; paint-order: stroke; }
.scaling .ideal { stroke: var(--soft); stroke-width: 1; stroke-dasharray: 2 4; }
</style>
)css";

/// Both axes of a chart: log10 of sizes and of nanoseconds.
struct LogFrame {
  double x0 = 0, y0 = 0;
  double first = 0, last = 1, low = 1e300, high = -1e300;
  double largest = 1;           ///< size
  std::vector<double> sizes{};  ///< that the axis shows

  [[nodiscard]] double x(double size) const {
    return x0 + frame_width * (std::log10(size) - first) / (last - first);
  }
  [[nodiscard]] double y(double ns) const {
    return y0 + frame_height * (1 - (std::log10(ns) - low) / (high - low));
  }
};

/// All charts of a curve have the same axes, so that they can be compared.
LogFrame frame_of(const std::vector<CurveChart>& charts) {
  LogFrame frame{.first = 1e300, .last = -1e300};
  std::set<double> sizes;
  for (const CurveChart& chart : charts)
    for (const CurveLine& line : chart.lines)
      for (const CurvePoint& point : line.points) {
        sizes.insert(static_cast<double>(point.size));
        const double size = std::log10(static_cast<double>(point.size));
        frame.first = std::min(frame.first, size), frame.last = std::max(frame.last, size);
        frame.low = std::min(frame.low, std::log10(point.low));
        frame.high = std::max(frame.high, std::log10(point.high));
      }
  frame.last = std::max(frame.last, frame.first + 0.1);
  const double wide = 0.04 * (frame.last - frame.first), tall = 0.05 * std::max(frame.high - frame.low, 0.2);
  if (!sizes.empty()) frame.largest = *sizes.rbegin();
  constexpr std::size_t room = 7;
  const auto is_power = [](double size) { return std::abs(std::remainder(std::log10(size), 1)) < 1e-9; };
  for (const double size : sizes)
    if (sizes.size() <= room || is_power(size)) frame.sizes.push_back(size);
  frame.first -= wide, frame.last += wide, frame.low -= tall, frame.high += tall;
  return frame;
}

/// "3", "1,000", and of large sizes "10⁵".
std::string size_in_words(double size) {
  if (size < 1e4) return size < 1000 ? fmt::format("{:g}", size) : fmt::format("{:g},000", size / 1000);
  constexpr std::array powers{"10⁴", "10⁵", "10⁶", "10⁷", "10⁸"};
  return powers.at(static_cast<std::size_t>(std::clamp(std::log10(size) - 4, 0.0, 4.0)));
}

/// The round numbers between two logarithms: powers of ten, with 3, or more, in between where there is
/// room.
std::vector<double> ticks_between(double low, double high) {
  const double decades = high - low;
  const std::vector<double> steps = decades < 1.5   ? std::vector<double>{1, 2, 3, 4, 6, 8}
                                    : decades < 3.5 ? std::vector<double>{1, 3}
                                                    : std::vector<double>{1};
  std::vector<double> ticks;
  for (int power = static_cast<int>(std::floor(low)); power <= static_cast<int>(std::ceil(high)); ++power)
    for (const double step : steps) {
      const double value = step * std::pow(10, power);
      if (std::log10(value) >= low && std::log10(value) <= high) ticks.push_back(value);
    }
  return ticks;
}

std::string axes(const LogFrame& frame, const std::string& title, const char* sizes) {
  const double bottom = frame.y0 + frame_height;
  std::string svg =
      fmt::format("<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\"/>\n", frame.x0,
                  frame.y0, frame_width, frame_height);
  for (const double size : frame.sizes) {
    svg += svg_line(frame.x(size), frame.y0, frame.x(size), bottom, "grid") +
           svg_text(frame.x(size), bottom + 20, "middle", size_in_words(size));
  }
  for (const double ns : ticks_between(frame.low, frame.high))
    svg += svg_line(frame.x0, frame.y(ns), frame.x0 + frame_width, frame.y(ns), "grid") +
           svg_text(frame.x0 - 8, frame.y(ns) + 5, "end", fmt::format("{:g}", ns));
  return svg + svg_text(frame.x0 + frame_width / 2, bottom + 42, "middle", sizes, "class=\"soft\"") +
         svg_text(frame.x0, frame.y0 - 12, "start", title, "class=\"title\"");
}

/// A disc, a square, a triangle, a lozenge, and a triangle on its tip, as paths from the point they mark.
constexpr std::array marks{"m-4.5 0a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0 -9 0z", "m-4.5 -4.5h9v9h-9z",
                           "m-5.5 5h11l-5.5 -10z", "m-6 0l6 6 6 -6 -6 -6z", "m-5.5 -5h11l-5.5 10z"};

std::string mark(std::size_t line, double x, double y, const std::string& words) {
  return fmt::format("<path class=\"mark\" d=\"M{:.1f} {:.1f}{}\"><title>{}</title></path>\n", x, y,
                     marks[line % marks.size()], escaped(words));
}

/// Heights of names, near those wanted and none on another.
std::vector<double> spread_out(const std::vector<double>& wanted, double low, double high) {
  constexpr double line_height = 19;
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, std::less{}, [&](std::size_t i) { return wanted[i]; });
  std::vector<double> heights = wanted;
  double next = low;
  for (const std::size_t i : order) next = (heights[i] = std::max(heights[i], next)) + line_height;
  double last = high;
  for (auto i = order.rbegin(); i != order.rend(); ++i)
    last = (heights[*i] = std::min(heights[*i], last)) - line_height;
  return heights;
}

std::string line_of(const CurveLine& line, std::size_t index, const LogFrame& frame, const char* sizes) {
  std::string path, points;
  for (const CurvePoint& point : line.points) {
    const double x = frame.x(static_cast<double>(point.size)), y = frame.y(point.ns);
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x, y);
    points += svg_line(x, frame.y(point.low), x, frame.y(point.high), "spread");
    points += mark(index, x, y,
                   fmt::format("{}, {} {}: {} ns ({} to {})", line.name, point.size, sizes,
                               nanoseconds(point.ns), nanoseconds(point.low), nanoseconds(point.high)));
  }
  return fmt::format("<path class=\"path\" d=\"{}\"/>\n{}", path, points);
}

/// Whether a line ends far from the names: it has its own at its last mark.
bool ends_early(const CurveLine& line, const LogFrame& frame) {
  return frame.x(static_cast<double>(line.points.back().size)) < frame.x(frame.largest) - 0.1 * frame_width;
}

std::string chart_in_svg(const CurveChart& chart, const LogFrame& frame, const char* sizes, bool has_ideal) {
  std::string svg = axes(frame, chart.title, sizes);
  std::vector<double> ends[2];  // of the lines that end beside the names, and of those that end early
  for (const CurveLine& line : chart.lines) {
    const bool is_early = ends_early(line, frame);
    ends[is_early].push_back(frame.y(line.points.back().ns) + (is_early ? -5 : 5));
  }
  for (std::vector<double>& side : ends) side = spread_out(side, frame.y0 + 12, frame.y0 + frame_height);
  std::size_t name[2] = {};
  for (std::size_t i = 0; i < chart.lines.size(); ++i) {
    const CurveLine& line = chart.lines[i];
    const CurvePoint &first = line.points.front(), &last = line.points.back();
    const double x = frame.x(static_cast<double>(last.size)), name_x = frame.x0 + frame_width + 18;
    if (has_ideal && line.points.size() > 1)
      svg += svg_line(
          frame.x(static_cast<double>(first.size)), frame.y(first.ns), x,
          frame.y(std::max(first.ns * static_cast<double>(first.size) / static_cast<double>(last.size),
                           std::pow(10, frame.low))),
          "ideal");
    svg += fmt::format("<g class=\"l{}\">\n{}", i % marks.size(), line_of(line, i, frame, sizes));
    const bool is_early = ends_early(line, frame);
    const double height = ends[is_early][name[is_early]++];
    if (is_early) {
      svg += svg_text(x - 10, height, "end", line.name, "class=\"label\"");
    } else {
      svg += svg_line(x + 7, frame.y(last.ns), name_x - 4, height - 5, "leader");
      svg += svg_text(name_x, height, "start", line.name, "class=\"label\"");
    }
    svg += "</g>\n";
  }
  return svg;
}

}  // namespace

std::string scaling_in_svg(const std::vector<BenchRow>& rows, const std::string& curve) {
  const std::vector<CurveChart> charts = charts_of(rows, curve);
  if (charts.empty()) return "";
  const CurveWords words = words_on(curve);
  LogFrame frame = frame_of(charts);
  std::string body;
  for (std::size_t i = 0; i < charts.size(); ++i) {
    frame.x0 = chart_left + chart_width * static_cast<double>(i % 2);
    frame.y0 = chart_top + (frame_height + chart_gap) * static_cast<double>(i / 2);
    body += chart_in_svg(charts[i], frame, words.sizes, curve == "threads");
  }
  const double bottom =
      chart_top + (frame_height + chart_gap) * static_cast<double>((charts.size() + 1) / 2) - 40;
  const double right = chart_width * (charts.size() > 1 ? 2 : 1.5) + 20;
  return fmt::format(
      "<svg class=\"scaling\" viewBox=\"0 0 {0:.0f} {1:.0f}\" role=\"img\" "
      "xmlns=\"http://www.w3.org/2000/svg\">\n<title>{2}</title>\n{3}<rect class=\"paper\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\"/>\n{4}{5}{6}</svg>\n",
      right, bottom, words.title, scaling_style,
      svg_text(10, 24, "start", fmt::format("{}: nanoseconds a ray over {}", words.title, words.sizes),
               "class=\"title\""),
      svg_text(10, 48, "start",
               lack_of(charts, curve).empty()
                   ? "bars: the middle half of the passes"
                   : "bars: the middle half of the passes." + lack_of(charts, curve),
               "class=\"soft\""),
      body);
}

}  // namespace rayproof::report
