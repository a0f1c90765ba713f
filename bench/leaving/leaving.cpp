#include "bench/leaving/leaving.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace rayproof::report {

namespace {

/// As bench/page/plot.cpp has them: safe for colour-blind readers.
constexpr std::array colours{"#555555", "#b84a00", "#9c4a7f", "#00734f", "#c79a00", "#0072b2"};
constexpr double width = 400, height = 260, left = 96, top = 44, gap_x = 110, gap_y = 88;
constexpr int first_decade = -6, last_decade = 6;

/// What stands up and down in a chart.
struct Scale {
  const char* title;
  double low, high;
  int step;
  [[nodiscard]] double place(double value) const {
    return height * (1 - (std::clamp(value, low, high) - low) / (high - low));
  }
};

struct ChartMark {
  double x, y;
  std::string words;
};

/// The marks of one strategy in one chart, a decade each.
using Line = std::vector<ChartMark>;

leaving::Count counted(const leaving::SearchResult& result, const leaving::Strategy* strategy,
                       Precision precision, std::size_t decade) {
  leaving::Count sum;
  for (const leaving::StrategyOutcome& outcome : result.outcomes)
    if (outcome.strategy == strategy && outcome.precision == precision)
      sum += outcome.tally.by_size.at(decade);
  return sum;
}

double x_of(double decade) { return width * (decade - first_decade) / (last_decade - first_decade); }

std::string text(double x, double y, const char* anchor, const std::string& words, const char* more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more,
                     words);
}

/// The frame, the decades of size below, the powers of ten beside.
std::string axes(const Scale& scale, const char* precision, bool of_shares) {
  std::string svg =
      fmt::format("<rect width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#222\"/>\n", width, height);
  for (int decade = first_decade; decade <= last_decade; decade += 2) {
    svg += fmt::format("<path d=\"M{0:.1f} 0V{1}\" stroke=\"#ddd\"/>\n", x_of(decade), height);
    svg += text(x_of(decade), height + 18, "middle", fmt::format("1e{}", decade));
  }
  const auto low = static_cast<int>(scale.low), high = static_cast<int>(scale.high);
  for (int power = low; power <= high; power += scale.step) {
    const bool is_none = of_shares && power == low;
    svg += fmt::format("<path d=\"M0 {0:.1f}H{1}\" stroke=\"#ddd\"/>\n", scale.place(power), width);
    svg += text(-8, scale.place(power) + 4, "end", is_none ? "none" : fmt::format("1e{}", power));
  }
  return svg + text(width / 2, height + 38, "middle", "size of the scene") +
         text(0, -12, "start", fmt::format("{}: {}", precision, scale.title), " font-weight=\"600\"");
}

std::string mark(std::size_t strategy, double x, double y, const std::string& words) {
  const char* colour = colours.at(strategy % colours.size());
  const std::string shape =
      strategy % 3 == 0 ? fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\"", x, y)
      : strategy % 3 == 1
          ? fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"8\" height=\"8\"", x - 4, y - 4)
          : fmt::format("<path d=\"M{:.1f} {:.1f}l5.5 5.5 -5.5 5.5 -5.5 -5.5z\"", x, y - 5.5);
  return fmt::format("{} fill=\"{}\" stroke=\"{}\" stroke-width=\"2\"><title>{}</title></{}>\n", shape,
                     strategy < 3 ? "#fff" : colour, colour, words,
                     strategy % 3 == 0   ? "circle"
                     : strategy % 3 == 1 ? "rect"
                                         : "path");
}

std::string drawn(std::size_t strategy, const Line& line) {
  std::string path, marks;
  for (const ChartMark& at : line) {
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", at.x, at.y);
    marks += mark(strategy, at.x, at.y, at.words);
  }
  return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"/>\n{}", path,
                     colours.at(strategy % colours.size()), marks);
}

/// One chart; the rays that `nothing` starts have no offset, and no line above.
std::string chart(const leaving::SearchResult& result, Precision precision, bool of_shares) {
  const bool is_float = precision == Precision::float32;
  const Scale scale = of_shares ? Scale{"share of false hits", -6, 0, 1}
                                : Scale{"median offset / size", is_float ? -8.0 : -18.0, is_float ? 2.0 : 2.0,
                                        is_float ? 2 : 4};
  std::string svg = axes(scale, name_of(precision), of_shares);
  for (std::size_t i = 0; i < leaving::strategies().size(); ++i) {
    const leaving::Strategy& strategy = leaving::strategies()[i];
    Line line;
    for (int decade = first_decade; decade < last_decade; ++decade) {
      const leaving::Count count =
          counted(result, &strategy, precision, static_cast<std::size_t>(decade - leaving::least_decade));
      const double value = of_shares ? static_cast<double>(count.false_hits) / static_cast<double>(count.rays)
                                     : count.offsets.median();
      if (count.rays == 0 || (!of_shares && value == 0)) continue;
      line.push_back({x_of(decade + 0.5), scale.place(value > 0 ? std::log10(value) : scale.low),
                      fmt::format("{}, size 1e{}: {} of {} rays, median offset {:.1e}", strategy.name, decade,
                                  count.false_hits, count.rays, count.offsets.median())});
    }
    svg += drawn(i, line);
  }
  return svg;
}

}  // namespace

std::string leaving_svg(const leaving::SearchResult& result) {
  std::string body;
  for (const bool of_shares : {false, true})
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      const double x = left + (precision == Precision::float32 ? 0 : width + gap_x);
      body += fmt::format("<g transform=\"translate({} {})\">\n{}</g>\n", x,
                          top + (of_shares ? height + gap_y : 0), chart(result, precision, of_shares));
    }
  const double legend = left + 2 * width + gap_x + 36;
  for (std::size_t i = 0; i < leaving::strategies().size(); ++i) {
    const double y = top + 10 + 26 * static_cast<double>(i);
    body += mark(i, legend, y, leaving::strategies()[i].title) +
            text(legend + 16, y + 5, "start", leaving::strategies()[i].name);
  }
  return fmt::format(
      "<svg viewBox=\"0 0 {0} {1}\" role=\"img\" xmlns=\"http://www.w3.org/2000/svg\" "
      "font-family=\"system-ui, sans-serif\" font-size=\"14\">\n<rect width=\"{0}\" height=\"{1}\" "
      "fill=\"#fff\"/>\n{2}</svg>\n",
      legend + 150, top + 2 * height + gap_y + 56, body);
}

}  // namespace rayproof::report
