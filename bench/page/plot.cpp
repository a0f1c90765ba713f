#include "bench/page/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rayproof::report {

namespace {

/// Safe for colour-blind readers (M. Okabe, K. Ito, "Color Universal Design", 2008), darkened for white paper
/// and lightened for a dark screen.
constexpr std::array<std::pair<const char*, const char*>, 4> colours{
    {{"#0072b2", "#56b4e9"}, {"#b84a00", "#ff8f4d"}, {"#00734f", "#2fc99a"}, {"#9c4a7f", "#e29ac6"}}};

PlotMark mark_of(const std::string& method, std::size_t index) {
  if (is_peer(method)) return {method, MarkOutline::triangle, Inner::nothing, "#5a626c", "#a3abb5"};
  const auto& [light, dark] = colours[index % colours.size()];
  return {method, static_cast<MarkOutline>(index % 3), static_cast<Inner>(index / 3 % 3), light, dark};
}

/// Where a share of wrong verdicts stands: log10 of it in percent, and a place of its own for none at all.
constexpr double none_wrong = -4.8;
double place_of_share(double share) {
  return share == 0 ? none_wrong : std::max(-4.0, std::log10(100 * share));
}

Axis share_axis() {
  Axis axis{"wrong verdicts", none_wrong - 0.4, 2.4, {{none_wrong, "none"}}};
  for (const auto& [place, text] :
       {std::pair{-4, "0.0001 %"}, std::pair{-3, "0.001 %"}, std::pair{-2, "0.01 %"}, std::pair{-1, "0.1 %"},
        std::pair{0, "1 %"}, std::pair{1, "10 %"}, std::pair{2, "100 %"}})
    axis.ticks.emplace_back(place, text);
  return axis;
}

Axis bits_axis(const std::vector<PlotPoint>& points) {
  double most = 1;
  for (const PlotPoint& point : points) most = std::max(most, point.y);
  const double step = most > 24 ? 8 : most > 10 ? 4 : most > 4 ? 2 : most > 2 ? 1 : 0.5;
  Axis axis{"bits of error, mean over agreed hits", -0.06 * most, 1.08 * most, {}};
  for (double place = 0; place <= axis.high; place += step)
    axis.ticks.emplace_back(place, fmt::format("{:g}", place));
  return axis;
}

Axis time_axis(const std::vector<MethodSummary>& summaries, Precision precision) {
  double low = 10;
  double high = -10;
  for (const MethodSummary& summary : summaries) {
    if (summary.precision != precision) continue;
    low = std::min(low, std::log10(summary.ns_per_ray));
    high = std::max(high, std::log10(summary.ns_per_ray));
  }
  Axis axis{"nanoseconds a ray", low - 0.25, high + 0.15, {}};
  for (const double ns : {0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1e3, 3e3, 1e4, 3e4, 1e5}) {
    const double place = std::log10(ns);
    const bool is_short = axis.high - axis.low < 3.2;
    const bool is_power = std::abs(place - std::round(place)) < 0.01;
    if (place > axis.low && place < axis.high && (is_short || is_power))
      axis.ticks.emplace_back(place, fmt::format("{:g}", ns));
  }
  return axis;
}

/// The stair under which no point lies: each step is a point that no other beats in both speed and error.
std::vector<std::pair<double, double>> front_of(std::vector<PlotPoint> points) {
  std::ranges::sort(points, [](const PlotPoint& a, const PlotPoint& b) {
    return std::pair{a.x, a.y} < std::pair{b.x, b.y};
  });
  std::vector<std::pair<double, double>> stair;
  for (const PlotPoint& point : points) {
    if (!stair.empty() && point.y >= stair.back().second) continue;
    if (!stair.empty()) stair.emplace_back(point.x, stair.back().second);
    stair.emplace_back(point.x, point.y);
  }
  return stair;
}

std::string label_of(const MethodSummary& summary) {
  return fmt::format("{}, {}: {:.3g} ns a ray, wrong verdicts {:.2g} %, {:.3g} bits of error", summary.method,
                     name_of(summary.arrangement), summary.ns_per_ray, 100 * summary.wrong_share(),
                     summary.accuracy.mean_bits);
}

std::vector<MethodSummary> of_shape(const std::vector<MethodSummary>& all, const std::string& shape) {
  std::vector<MethodSummary> chosen;
  std::ranges::copy_if(all, std::back_inserter(chosen),
                       [&](const MethodSummary& one) { return one.shape == shape; });
  return chosen;
}

/// The chart of one precision; `place` gives a summary's height.
template <class Place>
Panel make_panel(const Plot& plot, const std::vector<MethodSummary>& summaries, Precision precision,
                 const Place& place) {
  Panel panel;
  panel.title = name_of(precision);
  for (const MethodSummary& summary : summaries) {
    if (summary.precision != precision) continue;
    const double x = std::log10(summary.ns_per_ray);
    if (summary.is_floor()) panel.floor_x = x;
    if (summary.method == oracle_name) panel.oracle_x = x;
    const double y = place(summary);
    if (!summary.has_errors() || summary.accuracy.cases == 0 || std::isnan(y)) continue;
    const auto mark = std::ranges::find(plot.marks, summary.method, &PlotMark::method) - plot.marks.begin();
    panel.points.push_back({x, y, static_cast<std::size_t>(mark), summary.arrangement, label_of(summary)});
  }
  panel.front = front_of(panel.points);
  return panel;
}

Plot make_plot(const std::string& shape, const std::vector<MethodSummary>& summaries) {
  Plot plot{shape, {}, {}};
  for (const MethodSummary& summary : summaries) {
    const bool is_new = std::ranges::find(plot.marks, summary.method, &PlotMark::method) == plot.marks.end();
    if (is_new && summary.has_errors()) plot.marks.push_back(mark_of(summary.method, plot.marks.size()));
  }
  for (const bool is_share : {true, false}) {
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      Panel panel = make_panel(plot, summaries, precision, [&](const MethodSummary& summary) {
        return is_share ? place_of_share(summary.wrong_share()) : summary.accuracy.mean_bits;
      });
      if (panel.points.empty()) continue;
      panel.x = time_axis(summaries, precision);
      panel.y = is_share ? share_axis() : bits_axis(panel.points);
      plot.panels.push_back(std::move(panel));
    }
  }
  return plot;
}

}  // namespace

std::vector<Plot> make_plots(const std::vector<MethodSummary>& summaries) {
  std::vector<Plot> plots;
  for (const MethodSummary& summary : summaries) {
    if (std::ranges::find(plots, summary.shape, &Plot::shape) == plots.end())
      plots.push_back(make_plot(summary.shape, of_shape(summaries, summary.shape)));
  }
  return plots;
}

}  // namespace rayproof::report
