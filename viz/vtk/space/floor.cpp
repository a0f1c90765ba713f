#include "viz/vtk/space/floor.hpp"

#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

namespace rayproof::viz {
namespace {

constexpr double half_size = 5;     ///< of the floor, in the view's radii
constexpr double clearance = 0.12;  ///< between the lowest thing and the floor
constexpr double sheet = 0.002;     ///< between the floor, its grid and the shadows

int axis_of(const glm::dvec3& up) {
  for (int i = 0; i < 2; ++i) {
    if (up[i] != 0) return i;
  }
  return 2;
}

double lowest_of(const std::vector<vtkActor*>& actors, const glm::dvec3& up) {
  const int axis = axis_of(up);
  double lowest = -0.3;
  for (vtkActor* actor : actors) {
    const double* bounds = actor->GetBounds();
    const double own = up[axis] > 0 ? bounds[2 * axis] : -bounds[2 * axis + 1];
    lowest = std::min(lowest, own);
  }
  return std::max(lowest, -1.9);
}

vtkSmartPointer<vtkActor> plain_actor(vtkPolyData& data, double red, double green, double blue) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(&data);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(red, green, blue);
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkActor> grid_of(const glm::dvec3& centre, double radius, int axis, double height) {
  const double step = grid_step(radius) / radius;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const int across[2] = {(axis + 1) % 3, (axis + 2) % 3};
  for (int k = 0; k < 2; ++k) {
    const int along = across[1 - k];
    const double offset = centre[across[k]] / radius;
    for (double at = std::ceil((-half_size + offset) / step) * step - offset; at <= half_size; at += step) {
      lines->InsertNextCell(2);
      for (const double end : {-half_size, half_size}) {
        glm::dvec3 p;
        p[axis] = height;
        p[across[k]] = at;
        p[along] = end;
        lines->InsertCellPoint(points->InsertNextPoint(p.x, p.y, p.z));
      }
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  auto actor = plain_actor(*data, 0.82, 0.84, 0.87);
  actor->GetProperty()->SetLineWidth(1.2F);
  return actor;
}

}  // namespace

double grid_step(double radius) {
  const double rough = radius / 2;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= rough) return factor * power;
  }
  return power;
}

Floor floor_under(const std::vector<vtkActor*>& actors, const glm::dvec3& up, const glm::dvec3& centre,
                  double radius) {
  const int axis = axis_of(up);
  const double height = lowest_of(actors, up) - clearance;
  Floor floor;
  vtkNew<vtkPlaneSource> plane;
  glm::dvec3 corner(-half_size);
  corner[axis] = up[axis] * (height - 2 * sheet);
  glm::dvec3 one = corner;
  glm::dvec3 two = corner;
  one[(axis + 1) % 3] = half_size;
  two[(axis + 2) % 3] = half_size;
  plane->SetOrigin(&corner.x);
  plane->SetPoint1(&one.x);
  plane->SetPoint2(&two.x);
  plane->Update();
  floor.ground = plain_actor(*plane->GetOutput(), 0.955, 0.96, 0.967);
  floor.grid = grid_of(centre, radius, axis, up[axis] * (height - sheet));
  for (vtkActor* actor : actors) {
    vtkNew<vtkMatrix4x4> flatten;
    flatten->SetElement(axis, axis, 0);
    flatten->SetElement(axis, 3, up[axis] * height);
    auto shadow =
        plain_actor(*static_cast<vtkPolyDataMapper*>(actor->GetMapper())->GetInput(), 0.84, 0.86, 0.88);
    shadow->SetUserMatrix(flatten);
    floor.shadows.push_back(shadow);
  }
  return floor;
}

}  // namespace rayproof::viz
