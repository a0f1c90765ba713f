#include "bench/vtk/plot_png.hpp"

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>

#include <tuple>

#include "bench/vtk/chart_parts.hpp"
#include "viz/vtk/offscreen_display.hpp"
#include "viz/vtk/picture_png.hpp"

namespace rayproof::report {

namespace {

constexpr float panel_width = 640, panel_height = 440, legend_width = 300, margin = 12;
constexpr float marker_size = 17;
constexpr const char* paper = "#ffffff";
constexpr const char* ink = "#16181c";
constexpr const char* faint = "#5a626c";

/// A mark is put together of VTK's few markers: an outline, paper inside it where it is hollow, and a sign on
/// top.
void add_mark(vtkChartXY& chart, const PlotMark& mark, Arrangement arrangement, double x, double y) {
  if (mark.is_named_at_mark()) return;  // a name with a sign before it, see add_name
  constexpr int outlines[] = {vtkPlotPoints::SQUARE, vtkPlotPoints::CIRCLE, vtkPlotPoints::DIAMOND};
  const int outline = outlines[static_cast<std::size_t>(mark.outline)];
  const float size = mark.outline == MarkOutline::diamond ? marker_size + 4 : marker_size;
  const bool is_hollow = arrangement == Arrangement::scalar;
  add_marker(chart, x, y, outline, size + 4, paper);  // parts marks that lie on one another
  add_marker(chart, x, y, outline, size, mark.light);
  if (is_hollow)
    add_marker(chart, x, y, outline, size - (mark.outline == MarkOutline::diamond ? 6.5F : 5), paper);
  if (mark.inner == Inner::nothing) return;
  const int sign = mark.inner == Inner::plus ? vtkPlotPoints::PLUS : vtkPlotPoints::CROSS;
  add_marker(chart, x, y, sign, 10, is_hollow ? mark.light : paper);
}

/// A method's mark; of other people's libraries the name beside a triangle.
void add_point(vtkChartXY& chart, const PlotMark& mark, const PlotPoint& point, bool is_named_on_the_left) {
  add_mark(chart, mark, point.arrangement, point.x, point.y);
  if (!mark.is_named_at_mark()) return;
  const char* const sign = point.arrangement == Arrangement::scalar ? "△" : "▲";
  add_text(chart, point.x, point.y,
           is_named_on_the_left ? mark.method + " " + sign : sign + (" " + mark.method),
           is_named_on_the_left);
}

void place(vtkContextScene& scene, vtkChartXY& chart, float x, float y, float width, float height) {
  chart.SetAutoSize(false);
  chart.SetSize(vtkRectf(x, y, width, height));
  chart.SetShowLegend(false);
  scene.AddItem(&chart);
}

void add_panel(vtkContextScene& scene, const Plot& plot, const Panel& panel, float x, float y) {
  vtkNew<vtkChartXY> chart;
  place(scene, *chart, x, y, panel_width, panel_height);
  chart->SetTitle(panel.title + ": " + panel.y.title);
  set_font(*chart->GetTitleProperties(), 17, true);
  set_axis(*chart, vtkAxis::BOTTOM, panel.x, true);
  Axis height = panel.y;
  height.title.clear();  // the panel's title says it
  set_axis(*chart, vtkAxis::LEFT, height, true);
  for (const auto& [place, pattern, name] : {std::tuple{panel.floor_x, vtkPen::DASH_LINE, ""},
                                             std::tuple{panel.oracle_x, vtkPen::DASH_DOT_LINE, "oracle"}}) {
    if (!place) continue;
    add_line(*chart, {{*place, panel.y.low}, {*place, panel.y.high}}, pattern, faint);
    add_text(*chart, *place, panel.y.low + 0.97 * (panel.y.high - panel.y.low), name, false);
  }
  add_line(*chart, panel.front, vtkPen::DOT_LINE, ink);
  for (const PlotPoint& point : panel.points)
    add_point(*chart, plot.marks[point.mark], point, panel.is_named_on_the_left(point));
}

/// A chart without axes: a row for each method with its hollow and its solid mark.
void add_legend(vtkContextScene& scene, const Plot& plot, float x, float height) {
  std::vector<PlotMark> marks = plot.marks;
  std::erase_if(marks, [](const PlotMark& mark) { return mark.is_named_at_mark(); });
  const auto rows = static_cast<double>(marks.size()) + 2;
  Axis names{"", -rows + 0.5, 0.5, {{1 - rows, "streaming"}, {2 - rows, "Pareto front"}}};
  for (std::size_t i = 0; i < marks.size(); ++i)
    names.ticks.emplace_back(-static_cast<double>(i), marks[i].method);
  vtkNew<vtkChartXY> chart;
  const float own_height = 34 * static_cast<float>(rows) + 60;
  place(scene, *chart, x, height - own_height - 20, legend_width, own_height);
  set_axis(*chart, vtkAxis::BOTTOM, {"", -0.7, 1.7, {{0, "one"}, {1, "batch"}}}, false);
  set_axis(*chart, vtkAxis::LEFT, names, false);
  for (const int position : {vtkAxis::BOTTOM, vtkAxis::LEFT}) {
    chart->GetAxis(position)->SetAxisVisible(false);
    chart->GetAxis(position)->SetTicksVisible(false);
  }
  for (std::size_t i = 0; i < marks.size(); ++i) {
    add_mark(*chart, marks[i], Arrangement::scalar, 0, -static_cast<double>(i));
    add_mark(*chart, marks[i], Arrangement::batch, 1, -static_cast<double>(i));
  }
  add_line(*chart, {{-0.4, 2 - rows}, {1.4, 2 - rows}}, vtkPen::DOT_LINE, ink);
  add_line(*chart, {{-0.4, 1 - rows}, {1.4, 1 - rows}}, vtkPen::DASH_LINE, faint);
}

void draw(const Plot& plot, const std::string& path) {
  const auto rows = static_cast<float>((plot.panels.size() + 1) / 2);
  const float height = rows * panel_height + margin;
  vtkNew<vtkContextActor> actor;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  renderer->SetBackground(1, 1, 1);
  renderer->AddActor(actor);
  actor->GetScene()->SetRenderer(renderer);
  window->AddRenderer(renderer);
  window->SetSize(static_cast<int>(2 * (panel_width + margin) + legend_width), static_cast<int>(height));
  window->SetMultiSamples(8);
  for (std::size_t i = 0; i < plot.panels.size(); ++i) {
    const auto row = static_cast<float>(i / 2);
    add_panel(*actor->GetScene(), plot, plot.panels[i],
              margin + static_cast<float>(i % 2) * (panel_width + margin),
              height - margin - (row + 1) * panel_height);
  }
  add_legend(*actor->GetScene(), plot, 2 * (panel_width + margin), height);
  viz::write_png(viz::pixels_of(*window), path);
}

}  // namespace

std::vector<std::string> write_pngs(const std::vector<Plot>& plots, const std::filesystem::path& folder) {
  std::vector<std::string> written;
  try {
    const viz::OffscreenDisplay display;
    for (const Plot& plot : plots) {
      const std::string path = (folder / ("pareto-" + plot.shape + ".png")).string();
      draw(plot, path);
      written.push_back("plot: " + path);
    }
  } catch (const viz::NoDisplay& missing) {
    written.push_back(std::string("no PNG plots: ") + missing.what());
  }
  return written;
}

}  // namespace rayproof::report
