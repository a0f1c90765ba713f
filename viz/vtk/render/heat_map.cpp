#include "viz/vtk/render/error_figure.hpp"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkLinearSubdivisionFilter.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkScalarBarActor.h>
#include <vtkSphereSource.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkVariant.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "viz/render/errors.hpp"
#include "viz/vtk/picture_png.hpp"
#include "viz/vtk/sheet/picture_item.hpp"
#include "viz/vtk/space/geometry.hpp"

namespace rayproof::render {
namespace {

using viz::Geometry;

constexpr int width = 1600, height = 900;
constexpr double wrong_value = ulp_steps.size();
constexpr double unseen_value = wrong_value + 1;

/// Where a shape is: its picture's own coordinates have this centre as 0 and this size as 1, since VTK's are
/// floats.
struct SurfaceFrame {
  glm::dvec3 centre{};
  double size = 1;
  bool is_round = false;
};

SurfaceFrame frame_of(const Shape& shape) {
  if (const auto* sphere = std::get_if<Sphere<double>>(&shape)) return {sphere->center, sphere->radius, true};
  const auto& triangle = std::get<Triangle<double>>(shape);
  const glm::dvec3 centre = (triangle.a + triangle.b + triangle.c) / 3.0;
  const double size = std::max(
      {glm::length(triangle.a - centre), glm::length(triangle.b - centre), glm::length(triangle.c - centre)});
  return {centre, size, false};
}

/// The surface in many small faces, in the frame's coordinates.
Geometry faces_of(const Shape& shape, const SurfaceFrame& frame) {
  if (frame.is_round) {
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(1);
    ball->SetThetaResolution(144);
    ball->SetPhiResolution(96);
    ball->Update();
    return ball->GetOutput();
  }
  const auto& triangle = std::get<Triangle<double>>(shape);
  const auto place = [&](const glm::dvec3& p) { return (p - frame.centre) / frame.size; };
  vtkNew<vtkLinearSubdivisionFilter> divided;
  divided->SetInputData(viz::polygon_of({place(triangle.a), place(triangle.b), place(triangle.c)}));
  divided->SetNumberOfSubdivisions(6);
  divided->Update();
  return divided->GetOutput();
}

/// Asks for each face, and writes a step of ulps, or one of the two values beyond, on it.
HeatTotals colour(vtkPolyData& faces, const SurfaceFrame& frame, const glm::dvec3& eye,
                  const ErrorAt& error_at) {
  HeatTotals totals;
  vtkNew<vtkDoubleArray> values;
  for (vtkIdType face = 0; face < faces.GetNumberOfCells(); ++face) {
    glm::dvec3 middle(0);
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    faces.GetCellPoints(face, count, corners);
    for (vtkIdType i = 0; i < count; ++i) {
      glm::dvec3 corner;
      faces.GetPoint(corners[i], &corner.x);
      middle += corner / static_cast<double>(count);
    }
    const glm::dvec3 place = frame.centre + frame.size * middle;
    if (frame.is_round && glm::dot(eye - place, middle) <= 0) {
      values->InsertNextValue(unseen_value);
      continue;
    }
    const double ulps = error_at(place);
    ++totals.rays;
    totals.wrong += ulps < 0 ? 1 : 0;
    totals.worst_ulps = std::max(totals.worst_ulps, ulps);
    values->InsertNextValue(ulps < 0 ? wrong_value : static_cast<double>(step_of(ulps)));
  }
  faces.GetCellData()->SetScalars(values);
  return totals;
}

vtkSmartPointer<vtkLookupTable> colours() {
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->IndexedLookupOn();
  table->SetNumberOfTableValues(static_cast<vtkIdType>(ulp_steps.size()) + 2);
  const auto add = [&](double value, const std::string& label, const Rgb& rgb) {
    table->SetAnnotation(vtkVariant(value), label);
    table->SetTableValue(static_cast<vtkIdType>(value), rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0);
  };
  for (std::size_t i = 0; i < ulp_steps.size(); ++i)
    add(static_cast<double>(i), ulp_steps[i].label, ulp_colours[i]);
  add(wrong_value, "wrong verdict", verdict_styles[0].colour);
  add(unseen_value, "not seen", rgb_of("#b8bec6"));
  return table;
}

void write(vtkRenderer& renderer, const std::string& text, double y, int size, bool is_bold) {
  vtkNew<vtkTextActor> actor;
  actor->SetInput(text.c_str());
  actor->SetPosition(40, y);
  actor->GetTextProperty()->SetFontSize(size);
  actor->GetTextProperty()->SetColor(0.086, 0.094, 0.11);
  viz::use_legible_font(*actor->GetTextProperty(), is_bold);
  renderer.AddActor2D(actor);
}

void add_bar(vtkRenderer& renderer, vtkLookupTable& table) {
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(&table);
  bar->SetTitle("ulps of t");
  bar->SetPosition(0.76, 0.16);
  bar->SetPosition2(0.21, 0.66);
  bar->SetBarRatio(0.25);
  bar->SetDrawAnnotations(1);
  bar->SetDrawTickLabels(0);
  bar->SetUnconstrainedFontSize(true);
  for (vtkTextProperty* const text :
       {bar->GetTitleTextProperty(), bar->GetAnnotationTextProperty(), bar->GetLabelTextProperty()}) {
    text->SetFontSize(24);
    text->SetColor(0.086, 0.094, 0.11);
    text->ItalicOff();
    text->ShadowOff();
    viz::use_legible_font(*text);
  }
  renderer.AddActor2D(bar);
}

/// A little beside the eye, so that round things look round.
void look(vtkRenderer& renderer, const glm::dvec3& toward) {
  vtkCamera& camera = *renderer.GetActiveCamera();
  const glm::dvec3 up = std::abs(toward.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
  camera.SetFocalPoint(0, 0, 0);
  camera.SetPosition(toward.x, toward.y, toward.z);
  camera.SetViewUp(up.x, up.y, up.z);
  camera.Azimuth(25);
  camera.Elevation(15);
  camera.OrthogonalizeViewUp();
  renderer.ResetCamera();
  camera.Zoom(1.6);
}

}  // namespace

bool has_heat_map(const Shape& shape) {
  return std::holds_alternative<Sphere<double>>(shape) || std::holds_alternative<Triangle<double>>(shape);
}

viz::Raster heat_map(const Shape& shape, const glm::dvec3& eye, const ErrorAt& error_at,
                     const std::function<HeatWords(const HeatTotals&)>& words) {
  const SurfaceFrame frame = frame_of(shape);
  const Geometry faces = faces_of(shape, frame);
  const HeatWords written = words(colour(*faces, frame, eye, error_at));
  const auto table = colours();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(faces);
  mapper->SetLookupTable(table);
  mapper->SetScalarModeToUseCellData();
  vtkNew<vtkActor> surface;
  surface->SetMapper(mapper);
  surface->GetProperty()->SetAmbient(0.75);
  surface->GetProperty()->SetDiffuse(0.25);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(8);
  window->SetDPI(72);
  window->SetSize(width, height);
  vtkNew<vtkRenderer> backdrop, renderer;
  backdrop->SetBackground(1, 1, 1);
  renderer->SetBackground(1, 1, 1);
  renderer->SetViewport(0, 0.12, 0.75, 0.88);
  renderer->AddActor(surface);
  look(*renderer, glm::normalize(eye - frame.centre));
  write(*backdrop, written.title, height - 64, 36, true);
  write(*backdrop, written.caption, 40, 24, false);
  add_bar(*backdrop, *table);
  window->SetNumberOfLayers(2);
  renderer->SetLayer(1);
  window->AddRenderer(backdrop);
  window->AddRenderer(renderer);
  return viz::pixels_of(*window);
}

}  // namespace rayproof::render
