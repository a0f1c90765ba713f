#pragma once
/// \file
/// What the PNG plots are put together of, in terms of VTK's charts.

#include <string>
#include <utility>
#include <vector>

#include "bench/page/plot.hpp"

class vtkChartXY;
class vtkTextProperty;

namespace rayproof::report {

/// Points in plot units, joined in order.
using Polyline = std::vector<std::pair<double, double>>;

/// A legible font of `size` points in the ink's colour.
void set_font(vtkTextProperty& text, int size, bool bold = false);

/// A line through the points; `pattern` is one of vtkPen's, the colour is "#rrggbb". Fewer than two points
/// draw nothing.
void add_line(vtkChartXY& chart, const Polyline& polyline, int pattern, const char* colour);

/// One of vtkPlotPoints' markers at one point.
void add_marker(vtkChartXY& chart, double x, double y, int style, float size, const char* colour);

/// Words that begin, or end, at a point.
void add_text(vtkChartXY& chart, double x, double y, const std::string& words, bool ends_there);

/// Makes vtkAxis::BOTTOM or vtkAxis::LEFT show just this range and these ticks.
void set_axis(vtkChartXY& chart, int position, const Axis& axis, bool has_grid);

}  // namespace rayproof::report
