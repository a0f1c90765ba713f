#include "viz/vtk/space/space_scene.hpp"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkBox.h>
#include <vtkCamera.h>
#include <vtkLightKit.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "viz/picture/palette.hpp"
#include "viz/picture/raster.hpp"
#include "viz/vtk/space/floor.hpp"
#include "viz/vtk/space/geometry.hpp"

namespace rayproof::viz {
namespace {

vtkSmartPointer<vtkActor> actor_of(const Geometry& geometry, Role role) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(geometry);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  const auto [red, green, blue] = rgb_of(colour_of(role).light);
  vtkProperty& property = *actor->GetProperty();
  property.SetColor(red / 255.0, green / 255.0, blue / 255.0);
  property.SetInterpolationToPhong();
  property.SetAmbient(0.25);
  property.SetDiffuse(0.75);
  return actor;
}

/// The part of a segment within reach; nothing where there is none.
SpacePoints within_reach(const glm::dvec3& from, const glm::dvec3& to) {
  const double box[6] = {-reach, reach, -reach, reach, -reach, reach};
  double t[2];
  glm::dvec3 ends[2];
  int sides[2];
  const int meets =
      vtkBox::IntersectWithLine(box, &from.x, &to.x, t[0], t[1], &ends[0].x, &ends[1].x, sides[0], sides[1]);
  if (meets == 0 || ends[0] == ends[1]) return {};
  return {ends[0], ends[1]};
}

/// Of its tube, in the view's radii.
double line_radius(const ShownItem& shown) {
  constexpr double plain = 0.0085;
  if (shown.item->role == Role::frame) return 0.4 * plain;
  if (shown.emphasis == Emphasis::bright) return 1.5 * plain;
  if (shown.emphasis == Emphasis::dimmed) return 0.7 * plain;
  return shown.item->role == Role::ray ? 1.25 * plain : 0.8 * plain;
}

}  // namespace

void set_camera(vtkCamera& camera, const SpaceCamera& view) {
  const glm::dvec3 at = view.eye();
  camera.SetFocalPoint(view.middle.x, view.middle.y, view.middle.z);
  camera.SetPosition(at.x, at.y, at.z);
  camera.SetViewUp(view.up.x, view.up.y, view.up.z);
  camera.SetViewAngle(view_angle);
  camera.SetParallelProjection(view.is_flat ? 1 : 0);
  camera.SetParallelScale(view_margin);
  camera.SetClippingRange(view.nearest(), view.farthest());
}

SpaceScene::SpaceScene(vtkRenderer& renderer, const Stage& stage, std::size_t step, Look look)
    : renderer_(renderer), view_(stage.steps.at(step).view) {
  renderer_.RemoveAllViewProps();
  const std::vector<ShownItem> shown = shown_in(stage, step);
  camera_ = space_camera(stage, step, shown);
  place_camera(look);
  for (const ShownItem& one : shown) add(one);
  if (!camera_.is_flat) add_floor();
  renderer_.RemoveAllLights();
  vtkNew<vtkLightKit> lights;
  lights->AddLightsToRenderer(&renderer_);
}

void SpaceScene::place_camera(Look look) {
  vtkCamera& camera = *renderer_.GetActiveCamera();
  if (look == Look::anew) return set_camera(camera, camera_);
  SpaceCamera turned = camera_;
  camera.GetViewUp(&turned.up.x);
  camera.GetViewPlaneNormal(&camera_.toward.x);
  turned.toward = camera_.toward;
  if (look == Look::from_same_side) return set_camera(camera, turned);
  camera.GetFocalPoint(&camera_.middle.x);
  camera_.distance = camera.GetDistance();
  camera.SetClippingRange(camera_.nearest(), camera_.farthest());
}

std::vector<glm::dvec3> SpaceScene::placed(const StageItem& item) const {
  std::vector<glm::dvec3> points;
  for (const glm::dvec3& p : item.points) {
    const glm::dvec3 q = in_view(view_, p);
    const bool is_repeated = !points.empty() && q == points.back();  // a tube knows no line of length 0
    if (!is_repeated || item.form == Form::ellipsoid) points.push_back(q);
  }
  return points;
}

void SpaceScene::add(const ShownItem& shown) {
  const std::vector<glm::dvec3> points = placed(*shown.item);
  switch (shown.item->form) {
    case Form::point:
      return add_mark(shown, points.at(0));
    case Form::arrow:
    case Form::segment:
    case Form::polyline:
      return add_line(shown, points);
    case Form::polygon:
    case Form::hull:
    case Form::ellipsoid:
      return add_surface(shown, points);
  }
}

void SpaceScene::add_mark(const ShownItem& shown, const glm::dvec3& at) {
  if (!has_mark(shown.item->role) || glm::length(at) > reach) return;
  const double size = shown.emphasis == Emphasis::bright ? 0.034 : 0.027;
  // In a drawing what comes later stands before what was there, and marks before lines.
  const double height = camera_.is_flat ? 0.1 + 0.01 * renderer_.GetActors()->GetNumberOfItems() : 0;
  const glm::dvec3 place = at + height * camera_.toward;
  const Geometry mark = mark_geometry(mark_of(shown.item->role), place, size, camera_.toward);
  renderer_.AddActor(actor_of(mark, shown_role(shown)));
}

void SpaceScene::add_line(const ShownItem& shown, const std::vector<glm::dvec3>& points) {
  if (points.size() < 2) return;
  const StageItem& item = *shown.item;
  const double radius = line_radius(shown);
  // What is behind a translucent surface is seen to be: no dashes for it.
  const bool is_on_surface = item.role == Role::surface || item.role == Role::frame;
  const Pattern pattern = is_on_surface && !camera_.is_flat ? Pattern::solid : item.pattern;
  if (item.form == Form::polyline) {
    const auto is_near = [](const glm::dvec3& p) { return glm::length(p) < reach; };
    if (std::all_of(points.begin(), points.end(), is_near))
      renderer_.AddActor(actor_of(tube_of(points, radius, pattern), shown_role(shown)));
    return;
  }
  const SpacePoints part = within_reach(points[0], points[1]);
  if (part.empty()) return;
  const bool has_head = item.form == Form::arrow && part[1] == points[1];
  const Geometry line = has_head ? arrow_of(part[0], part[1], radius) : tube_of(part, radius, pattern);
  renderer_.AddActor(actor_of(line, shown_role(shown)));
}

void SpaceScene::add_surface(const ShownItem& shown, const std::vector<glm::dvec3>& points) {
  const Form form = shown.item->form;
  const Geometry surface = form == Form::polygon     ? polygon_of(points)
                           : form == Form::ellipsoid ? ellipsoid_of(points)
                                                     : hull_of(points);
  const auto body = actor_of(surface, shown_role(shown));
  const bool is_dimmed = shown.emphasis == Emphasis::dimmed;
  vtkProperty& property = *body->GetProperty();
  property.SetOpacity(is_dimmed ? 0.12 : form == Form::polygon ? 0.4 : 0.2);
  property.SetSpecular(is_dimmed ? 0 : 0.25);
  property.SetSpecularPower(30);
  if (camera_.is_flat) property.LightingOff();
  renderer_.AddActor(body);
  renderer_.AddActor(actor_of(silhouette_of(surface, camera_.eye(), line_radius(shown)), shown_role(shown)));
}

void SpaceScene::add_floor() {
  std::vector<vtkActor*> bodies;
  vtkActorCollection& all = *renderer_.GetActors();
  all.InitTraversal();
  while (vtkActor* actor = all.GetNextActor()) bodies.push_back(actor);
  const Floor floor = floor_under(bodies, camera_.up, view_.centre, view_.radius);
  renderer_.AddActor(floor.ground);
  renderer_.AddActor(floor.grid);
  for (const auto& shadow : floor.shadows) renderer_.AddActor(shadow);
}

std::vector<Point> SpaceScene::seen(const StageItem& item, const PixelBox& frame) const {
  std::vector<Point> pixels;
  if (item.form == Form::ellipsoid) return pixels;
  for (const glm::dvec3& p : placed(item)) {
    // What is behind the eye has no place in the picture.
    if (!camera_.is_flat && glm::dot(camera_.eye() - p, camera_.toward) < camera_.nearest()) continue;
    renderer_.SetWorldPoint(p.x, p.y, p.z, 1);
    renderer_.WorldToView();
    double at[3];
    renderer_.GetViewPoint(at);
    pixels.push_back(
        {frame.left + (at[0] + 1) / 2 * frame.width, frame.top + (1 - at[1]) / 2 * frame.height});
  }
  return pixels;
}

}  // namespace rayproof::viz
