#include "bench/page/plot_svg.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bench/page/svg.hpp"

namespace rayproof::report {

namespace {

constexpr double panel_width = 400, panel_height = 300, left = 92, top = 40, gap_x = 110, gap_y = 96;
constexpr double name_in_legend = 72;  // right of the two marks
constexpr std::size_t columns = 2;

/// Where plot units lie on the paper.
struct Frame {
  const Panel& panel;
  double x0, y0;
  [[nodiscard]] double x(double value) const {
    return x0 + panel_width * (value - panel.x.low) / (panel.x.high - panel.x.low);
  }
  [[nodiscard]] double y(double value) const {
    return y0 + panel_height * (1 - (value - panel.y.low) / (panel.y.high - panel.y.low));
  }
};

std::string outline(MarkOutline shape, double x, double y, double r, const char* style) {
  switch (shape) {
    case MarkOutline::square:
      return fmt::format("<rect{} x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\"/>", style, x - r,
                         y - r, 2 * r, 2 * r);
    case MarkOutline::circle:
      return fmt::format("<circle{} cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>", style, x, y, r + 0.5);
    case MarkOutline::triangle:
      return fmt::format("<path{0} d=\"M{1:.1f} {2:.1f}h{3}l-{4} -{3}z\"/>", style, x - r - 1, y + r - 1,
                         2 * r + 2, r + 1);
    case MarkOutline::diamond:
      break;
  }
  const double d = r + 2.5;
  return fmt::format("<path{0} d=\"M{1:.1f} {2:.1f}l{3} {3} {3} -{3} -{3} -{3}z\"/>", style, x - d, y, d);
}

std::string inner(Inner sign, double x, double y) {
  if (sign == Inner::nothing) return "";
  const double a = sign == Inner::plus ? 5 : 3.5;
  const double b = sign == Inner::plus ? 0 : 3.5;
  return fmt::format("<path class=\"in\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>",
                     x - a, y - b, x + a, y + b, x + b, y - a, x - b, y + a);
}

std::string mark(const PlotMark& one, std::size_t index, Arrangement arrangement, double x, double y,
                 const std::string& label) {
  const char* fill = arrangement == Arrangement::scalar ? "hollow" : "solid";
  constexpr double r = 7;
  return fmt::format("<g class=\"m{} {}\"><title>{}</title>{}{}{}</g>\n", index, fill, escaped(label),
                     outline(one.outline, x, y, r + 2.5, " class=\"halo\""),
                     outline(one.outline, x, y, r, ""), inner(one.inner, x, y));
}

std::string axes(const Frame& frame) {
  const double bottom = frame.y0 + panel_height;
  std::string svg =
      fmt::format("<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\"/>\n", frame.x0,
                  frame.y0, panel_width, panel_height);
  for (const auto& [place, words] : frame.panel.x.ticks) {
    svg += svg_line(frame.x(place), frame.y0, frame.x(place), bottom, "grid");
    svg += svg_text(frame.x(place), bottom + 18, "middle", words);
  }
  for (const auto& [place, words] : frame.panel.y.ticks) {
    svg += svg_line(frame.x0, frame.y(place), frame.x0 + panel_width, frame.y(place), "grid");
    svg += svg_text(frame.x0 - 8, frame.y(place) + 4.5, "end", words);
  }
  svg += svg_text(frame.x0 + panel_width / 2, bottom + 40, "middle", frame.panel.x.title, "class=\"axis\"");
  svg += svg_text(frame.x0, frame.y0 - 12, "start", frame.panel.title + ": " + frame.panel.y.title,
                  "class=\"title\"");
  return svg;
}

/// A line from top to bottom with its name along it, where `place` is one.
std::string upright(const Frame& frame, const std::optional<double>& place, const char* style,
                    const char* name) {
  if (!place) return "";
  const double x = frame.x(*place);
  return svg_line(x, frame.y0, x, frame.y0 + panel_height, style) +
         fmt::format("<text class=\"note\" transform=\"translate({:.1f} {:.1f}) rotate(-90)\">{}</text>\n",
                     x - 5, frame.y0 + panel_height - 6, name);
}

std::string chart(const Plot& plot, const Frame& frame) {
  std::string svg = axes(frame) + upright(frame, frame.panel.floor_x, "floor", "streaming") +
                    upright(frame, frame.panel.oracle_x, "oracle", "oracle");
  std::string stair;
  for (const auto& [x, y] : frame.panel.front) stair += fmt::format("{:.1f},{:.1f} ", frame.x(x), frame.y(y));
  svg += "<polyline class=\"front\" points=\"" + stair + "\"/>\n";
  for (const PlotPoint& point : frame.panel.points) {
    const PlotMark& own = plot.marks[point.mark];
    const double x = frame.x(point.x), y = frame.y(point.y);
    svg += mark(own, point.mark, point.arrangement, x, y, point.label);
    if (!own.is_named_at_mark()) continue;
    const bool is_left = frame.panel.is_named_on_the_left(point);
    svg +=
        svg_text(is_left ? x - 12 : x + 12, y + 5, is_left ? "end" : "start", own.method, "class=\"name\"");
  }
  return svg;
}

std::string legend(const Plot& plot, double x) {
  std::string svg = svg_text(x + 8, top + 4, "middle", "one", "class=\"note\"") +
                    svg_text(x + 48, top + 4, "middle", "batch", "class=\"note\"");
  double y = top + 26;
  for (std::size_t i = 0; i < plot.marks.size(); ++i) {
    if (plot.marks[i].is_named_at_mark()) continue;
    svg +=
        mark(plot.marks[i], i, Arrangement::scalar, x + 8, y, plot.marks[i].method + ", one ray at a time");
    svg += mark(plot.marks[i], i, Arrangement::batch, x + 48, y, plot.marks[i].method + ", in batches");
    svg += svg_text(x + name_in_legend, y + 5, "start", plot.marks[i].method);
    y += 28;
  }
  svg += svg_line(x, y + 4, x + 56, y + 4, "front") +
         svg_text(x + name_in_legend, y + 9, "start", "Pareto front");
  svg += svg_line(x, y + 32, x + 56, y + 32, "floor") +
         svg_text(x + name_in_legend, y + 37, "start", "streaming");
  return svg;
}

/// Room for the longest name: in the font of the plot it takes less than 9 a letter.
double legend_width(const Plot& plot) {
  std::size_t letters = 12;  // "Pareto front"
  for (const PlotMark& mark : plot.marks) letters = std::max(letters, mark.method.size());
  return name_in_legend + 9 * static_cast<double>(letters);
}

std::string style(const Plot& plot) {
  std::string light;
  std::string dark;
  for (std::size_t i = 0; i < plot.marks.size(); ++i) {
    light += fmt::format(".{0} .m{1}{{--m:{2}}}", plot.shape, i, plot.marks[i].light);
    dark += fmt::format(".{0} .m{1}{{--m:{2}}}", plot.shape, i, plot.marks[i].dark);
  }
  return "<style>" + light + "@media screen and (prefers-color-scheme:dark){" + dark + "}</style>\n";
}

}  // namespace

std::string to_svg(const Plot& plot) {
  const std::size_t rows = (plot.panels.size() + columns - 1) / columns;
  const double legend_x = left + 2 * panel_width + gap_x + 36;
  std::string body;
  for (std::size_t i = 0; i < plot.panels.size(); ++i) {
    const auto column = static_cast<double>(i % columns);
    const auto row = static_cast<double>(i / columns);
    body += chart(
        plot, {plot.panels[i], left + column * (panel_width + gap_x), top + row * (panel_height + gap_y)});
  }
  return fmt::format(
      "<svg class=\"plot {0}\" viewBox=\"0 0 {1} {2}\" role=\"img\" xmlns=\"http://www.w3.org/2000/svg\">\n"
      "<title>Speed against error of the {0} methods</title>\n{3}{4}{5}</svg>\n",
      escaped(plot.shape), legend_x + legend_width(plot),
      top + static_cast<double>(rows) * (panel_height + gap_y) - 30, style(plot), body,
      legend(plot, legend_x));
}

}  // namespace rayproof::report
