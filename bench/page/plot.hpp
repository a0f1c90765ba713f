#pragma once
/// \file
/// The plot of speed against error as data; SVG (plot_svg.hpp) and VTK (bench/vtk) draw it.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/figures/summary.hpp"

namespace rayproof::report {

/// A method's mark: the outline, what is inside it, and the colour differ, so that colour is never needed to
/// distinguish two methods. One ray at a time is drawn hollow, a batch solid.
enum class MarkOutline { square, circle, diamond, triangle };
enum class Inner { nothing, plus, cross };

struct PlotMark {
  std::string method;
  MarkOutline outline = MarkOutline::square;
  Inner inner = Inner::nothing;
  const char* light = "";  ///< colour on white, #rrggbb
  const char* dark = "";   ///< colour on near-black

  /// Other people's libraries are all triangles, each with its name beside it; they stand in no legend.
  [[nodiscard]] bool is_named_at_mark() const { return outline == MarkOutline::triangle; }
};

/// An axis in plot units; each tick is a position and the text that stands there.
struct Axis {
  std::string title;
  double low = 0;
  double high = 1;
  std::vector<std::pair<double, std::string>> ticks;
};

struct PlotPoint {
  double x = 0;
  double y = 0;
  std::size_t mark = 0;  ///< index into Plot::marks
  Arrangement arrangement = Arrangement::scalar;
  std::string label;  ///< the figures in words
};

/// One chart: speed across, one kind of error up.
struct Panel {
  /// Whether a mark's name stands to its left: that of a batch, which may be near its scalar; and where there
  /// is no room to the right.
  [[nodiscard]] bool is_named_on_the_left(const PlotPoint& point) const {
    return point.arrangement == Arrangement::batch || point.x > x.low + 0.8 * (x.high - x.low);
  }

  std::string title;
  Axis x, y;
  std::vector<PlotPoint> points;
  std::vector<std::pair<double, double>>
      front;                         ///< the Pareto front as a stair, from the fastest to the best
  std::optional<double> floor_x{};   ///< where merely streaming the rays lies
  std::optional<double> oracle_x{};  ///< where the exact judge lies
};

/// The charts of one shape: a column for each precision, wrong verdicts above mean bits.
struct Plot {
  std::string shape;
  std::vector<PlotMark> marks;
  std::vector<Panel> panels;
};

/// One plot for each shape.
[[nodiscard]] std::vector<Plot> make_plots(const std::vector<MethodSummary>& summaries);

}  // namespace rayproof::report
