#include "bench/vtk/chart_parts.hpp"

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContext2D.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <string>

#include "viz/vtk/sheet/picture_item.hpp"

namespace rayproof::report {

namespace {

/// "#rrggbb" as the number VTK's pens take.
void set_colour(vtkPlot& plot, const char* hex) {
  const unsigned long rgb = std::stoul(hex + 1, nullptr, 16);
  plot.SetColor(static_cast<unsigned char>(rgb >> 16U), static_cast<unsigned char>(rgb >> 8U & 0xFFU),
                static_cast<unsigned char>(rgb & 0xFFU), 255);
}

vtkPlot& add_plot(vtkChartXY& chart, int kind, const Polyline& polyline) {
  vtkNew<vtkDoubleArray> xs;
  vtkNew<vtkDoubleArray> ys;
  xs->SetName("x");
  ys->SetName("y");
  for (const auto& [x, y] : polyline) {
    xs->InsertNextValue(x);
    ys->InsertNextValue(y);
  }
  vtkNew<vtkTable> table;
  table->AddColumn(xs);
  table->AddColumn(ys);
  vtkPlot* plot = chart.AddPlot(kind);
  plot->SetInputData(table, 0, 1);
  return *plot;
}

}  // namespace

void set_font(vtkTextProperty& text, int size, bool bold) {
  viz::use_legible_font(text, bold);
  text.SetFontSize(size);
  text.SetColor(0.086, 0.094, 0.11);
}

void add_line(vtkChartXY& chart, const Polyline& polyline, int pattern, const char* colour) {
  if (polyline.size() < 2) return;
  vtkPlot& line = add_plot(chart, vtkChart::LINE, polyline);
  set_colour(line, colour);
  line.SetWidth(2.0F);
  line.GetPen()->SetLineType(pattern);
}

void add_marker(vtkChartXY& chart, double x, double y, int style, float size, const char* colour) {
  auto& marker = dynamic_cast<vtkPlotPoints&>(add_plot(chart, vtkChart::POINTS, {{x, y}}));
  marker.SetMarkerStyle(style);
  marker.SetMarkerSize(size);
  set_colour(marker, colour);
}

namespace {

/// Words at a place of a chart.
class TextInChart : public vtkPlot {
 public:
  static TextInChart* New();
  bool Paint(vtkContext2D* painter) override {
    painter->ApplyTextProp(font);
    painter->DrawString(static_cast<float>(x), static_cast<float>(y), words);
    return true;
  }

  double x = 0, y = 0;
  std::string words{};
  vtkNew<vtkTextProperty> font{};
};
vtkStandardNewMacro(TextInChart);

}  // namespace

void add_text(vtkChartXY& chart, double x, double y, const std::string& words, bool ends_there) {
  vtkNew<TextInChart> text;
  text->x = x;
  text->y = y;
  text->words = words;
  set_font(*text->font, 15);
  text->font->SetJustification(ends_there ? VTK_TEXT_RIGHT : VTK_TEXT_LEFT);
  text->font->SetVerticalJustification(VTK_TEXT_CENTERED);
  chart.AddPlot(text);
}

void set_axis(vtkChartXY& chart, int position, const Axis& axis, bool has_grid) {
  vtkAxis* drawn = chart.GetAxis(position);
  vtkNew<vtkDoubleArray> places;
  vtkNew<vtkStringArray> labels;
  for (const auto& [place, text] : axis.ticks) {
    places->InsertNextValue(place);
    labels->InsertNextValue(text);
  }
  drawn->SetBehavior(vtkAxis::FIXED);
  drawn->SetRange(axis.low, axis.high);
  drawn->SetCustomTickPositions(places, labels);
  drawn->SetTitle(axis.title);
  drawn->SetGridVisible(has_grid);
  drawn->GetGridPen()->SetColor(216, 219, 223, 255);
  set_font(*drawn->GetLabelProperties(), 15);
  set_font(*drawn->GetTitleProperties(), 15);
}

}  // namespace rayproof::report
