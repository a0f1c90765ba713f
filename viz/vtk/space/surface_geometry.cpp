#include <vtkCellArray.h>
#include <vtkContourTriangulator.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkPolyDataSilhouette.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>

#include "viz/vtk/space/geometry.hpp"

namespace rayproof::viz {
namespace {

vtkSmartPointer<vtkActor> plain_actor(const Geometry& geometry, const RoleColour& colour) {
  auto actor = actor_of(geometry, colour);
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkActor> grid_of(const SpaceFloor& place) {
  std::vector<SpacePoints> lines;
  for (std::size_t k = 0; k < 2; ++k) {
    for (const double at : place.lines[k]) {
      glm::dvec3 end(floor_reach);
      end[place.axis] = place.grid;
      end[place.across(k)] = at;
      glm::dvec3 start = end;
      start[place.across(1 - k)] = -floor_reach;
      lines.push_back({start, end});
    }
  }
  auto actor = plain_actor(lines_of(lines), floor_colours.grid);
  actor->GetProperty()->SetLineWidth(1.2F);
  return actor;
}

}  // namespace

Geometry ring_of(const SpacePoints& corners, double radius, int sides) {
  // Side by side: a tube around a sharp corner would be pinched there.
  std::vector<SpacePoints> lines;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3& next = corners[(i + 1) % corners.size()];
    if (next != corners[i]) lines.push_back({corners[i], next});
  }
  return tubes_of(lines_of(lines), radius, sides);
}

Geometry polygon_of(const SpacePoints& corners, const std::vector<SpacePoints>& strips) {
  if (!strips.empty()) {
    const Geometry filled = lines_of(strips);
    filled->SetPolys(filled->GetLines());
    filled->SetLines(nullptr);
    return filled;
  }
  SpacePoints ring = corners;
  ring.push_back(corners.front());
  vtkNew<vtkContourTriangulator> filled;
  filled->SetInputData(lines_of({ring}));
  filled->Update();
  return filled->GetOutput();
}

Geometry solid_of(const SpacePoints& corners, const std::vector<std::vector<std::size_t>>& faces) {
  vtkNew<vtkPolyData> made;
  vtkNew<vtkCellArray> cells;
  for (const auto& face : faces) {
    cells->InsertNextCell(static_cast<int>(face.size()));
    for (const std::size_t corner : face) cells->InsertCellPoint(static_cast<vtkIdType>(corner));
  }
  made->SetPoints(points_of(corners));
  made->SetPolys(cells);
  vtkNew<vtkPolyDataNormals> normals;  // round sides look round, edges stay sharp
  normals->SetInputData(made);
  normals->SetFeatureAngle(30);
  normals->ConsistencyOn();
  normals->AutoOrientNormalsOn();
  normals->Update();
  return normals->GetOutput();
}

Geometry ellipsoid_of(const SpacePoints& centre_and_tips, int sides) {
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(1);
  ball->SetThetaResolution(6 * sides);
  ball->SetPhiResolution(4 * sides);
  vtkNew<vtkMatrix4x4> matrix;
  const glm::dvec3& centre = centre_and_tips.at(0);
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 tip = centre_and_tips.at(static_cast<std::size_t>(axis) + 1) - centre;
    for (int i = 0; i < 3; ++i) matrix->SetElement(i, axis, tip[i]);
    matrix->SetElement(axis, 3, centre[axis]);
  }
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(matrix);
  return placed(*ball, *transform);
}

Geometry silhouette_of(const Geometry& surface, const glm::dvec3& eye, double radius, int sides) {
  vtkNew<vtkPolyDataSilhouette> silhouette;
  silhouette->SetInputData(surface);
  silhouette->SetDirectionToSpecifiedOrigin();
  silhouette->SetOrigin(eye.x, eye.y, eye.z);
  silhouette->SetEnableFeatureAngle(1);
  silhouette->SetFeatureAngle(30);
  silhouette->BorderEdgesOn();
  silhouette->Update();
  return tubes_of(silhouette->GetOutput(), radius, sides);
}

Floor floor_under(const std::vector<vtkActor*>& actors, const SpaceFloor& place) {
  Floor floor;
  vtkNew<vtkPlaneSource> plane;
  glm::dvec3 corner(-floor_reach);
  corner[place.axis] = place.ground;
  glm::dvec3 one = corner;
  glm::dvec3 two = corner;
  one[place.across(0)] = floor_reach;
  two[place.across(1)] = floor_reach;
  plane->SetOrigin(&corner.x);
  plane->SetPoint1(&one.x);
  plane->SetPoint2(&two.x);
  plane->Update();
  floor.ground = plain_actor(plane->GetOutput(), floor_colours.ground);
  floor.grid = grid_of(place);
  for (vtkActor* actor : actors) {
    vtkNew<vtkMatrix4x4> flatten;
    flatten->SetElement(place.axis, place.axis, 0);
    flatten->SetElement(place.axis, 3, place.shadows);
    auto shadow =
        plain_actor(static_cast<vtkPolyDataMapper*>(actor->GetMapper())->GetInput(), floor_colours.shadow);
    shadow->SetUserMatrix(flatten);
    floor.shadows.push_back(shadow);
  }
  return floor;
}

}  // namespace rayproof::viz
