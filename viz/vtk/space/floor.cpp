#include "viz/vtk/space/geometry.hpp"

#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

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
