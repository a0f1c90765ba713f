#include <vtkAlgorithm.h>
#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkConeSource.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPlatonicSolidSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTubeFilter.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "viz/vtk/space/geometry.hpp"

namespace rayproof::viz {
namespace {

/// With its z axis turned to the eye and its y axis upright.
vtkSmartPointer<vtkTransform> turned(const glm::dvec3& at, const SpaceCamera& camera, double size) {
  const glm::dvec3& z = camera.toward;
  const glm::dvec3 x = glm::normalize(glm::cross(camera.up, z));
  const glm::dvec3 y = glm::cross(z, x);
  vtkNew<vtkMatrix4x4> matrix;
  for (int i = 0; i < 3; ++i) {
    matrix->SetElement(i, 0, size * x[i]);
    matrix->SetElement(i, 1, size * y[i]);
    matrix->SetElement(i, 2, size * z[i]);
    matrix->SetElement(i, 3, at[i]);
  }
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(matrix);
  return transform;
}

}  // namespace

vtkSmartPointer<vtkPoints> points_of(const SpacePoints& points) {
  vtkNew<vtkPoints> made;
  made->SetDataTypeToDouble();
  for (const glm::dvec3& p : points) made->InsertNextPoint(p.x, p.y, p.z);
  return made;
}

Geometry lines_of(const std::vector<SpacePoints>& lines) {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkCellArray> cells;
  SpacePoints all;
  for (const SpacePoints& line : lines) {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const glm::dvec3& p : line) {
      cells->InsertCellPoint(static_cast<vtkIdType>(all.size()));
      all.push_back(p);
    }
  }
  data->SetPoints(points_of(all));
  data->SetLines(cells);
  return data;
}

Geometry placed(vtkAlgorithm& source, vtkTransform& transform) {
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetInputConnection(source.GetOutputPort());
  filter->SetTransform(&transform);
  filter->Update();
  return filter->GetOutput();
}

Geometry tubes_of(const Geometry& lines, double radius, int sides) {
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(lines);
  tube->SetRadius(radius);
  tube->SetNumberOfSides(sides);
  tube->CappingOn();
  tube->Update();
  return tube->GetOutput();
}

void set_colour(vtkProperty& property, const RoleColour& colour) {
  const auto [red, green, blue] = rgb_of(colour.light);
  property.SetColor(red / 255.0, green / 255.0, blue / 255.0);
}

vtkSmartPointer<vtkActor> actor_of(const Geometry& geometry, const RoleColour& colour) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(geometry);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  set_colour(*actor->GetProperty(), colour);
  return actor;
}

Geometry line_geometry(const std::vector<SpacePoints>& pieces, const std::optional<ArrowHead>& head,
                       double radius, int sides) {
  const Geometry tubes = tubes_of(lines_of(pieces), radius, sides);
  if (!head) return tubes;
  const glm::dvec3 along = head->tip - head->base;
  const glm::dvec3 middle = 0.5 * (head->base + head->tip);
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(sides * 3 / 2);
  cone->SetHeight(glm::length(along));
  cone->SetRadius(head->radius);
  cone->SetCenter(middle.x, middle.y, middle.z);
  cone->SetDirection(along.x, along.y, along.z);
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(tubes);
  both->AddInputConnection(cone->GetOutputPort());
  both->Update();
  return both->GetOutput();
}

Geometry mark_geometry(MarkShape shape, const glm::dvec3& at, double radius, const SpaceCamera& camera,
                       int sides) {
  const auto transform = turned(at, camera, radius);
  switch (shape) {
    case MarkShape::ring: {
      vtkNew<vtkParametricTorus> torus;
      torus->SetRingRadius(mark_measures.ring);
      torus->SetCrossSectionRadius(mark_measures.wire);
      vtkNew<vtkParametricFunctionSource> source;
      source->SetParametricFunction(torus);
      source->SetUResolution(3 * sides);
      source->SetVResolution(sides);
      return placed(*source, *transform);
    }
    case MarkShape::diamond: {
      vtkNew<vtkPlatonicSolidSource> source;
      source->SetSolidTypeToOctahedron();
      transform->RotateZ(45);  // its corners up, down, left and right
      transform->Scale(mark_measures.diamond, mark_measures.diamond, mark_measures.diamond);
      return placed(*source, *transform);
    }
    case MarkShape::cross: {
      constexpr double arm = mark_measures.cross;
      const Geometry both = lines_of({{{-arm, -arm, 0}, {arm, arm, 0}}, {{-arm, arm, 0}, {arm, -arm, 0}}});
      vtkNew<vtkAppendPolyData> tubes;
      tubes->AddInputData(tubes_of(both, mark_measures.wire, sides));
      return placed(*tubes, *transform);
    }
    case MarkShape::dot: {
      vtkNew<vtkSphereSource> source;
      source->SetRadius(mark_measures.dot);
      source->SetThetaResolution(sides * 3 / 2);
      source->SetPhiResolution(sides * 3 / 2);
      return placed(*source, *transform);
    }
  }
  return vtkSmartPointer<vtkPolyData>::New();
}

}  // namespace rayproof::viz
