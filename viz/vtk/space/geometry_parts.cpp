#include "viz/vtk/space/geometry_parts.hpp"

#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTubeFilter.h>

namespace rayproof::viz {

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

}  // namespace rayproof::viz
