#include "viz/vtk/space/space_scene.hpp"

#include <vtkActor.h>
#include <vtkBox.h>
#include <vtkCamera.h>
#include <vtkLightKit.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "viz/palette.hpp"
#include "viz/raster.hpp"
#include "viz/stage/fit_view.hpp"
#include "viz/vtk/space/floor.hpp"
#include "viz/vtk/space/solid_geometry.hpp"

namespace rayproof::viz {
namespace {

/// How far around the view things are built, in its radii.
constexpr double reach = 6;
constexpr double view_angle = 24;  ///< degrees, from top to bottom
constexpr double elevation = 20;   ///< degrees, of the eye above the floor
constexpr double margin = 1.14;    ///< for marks and labels

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

vtkSmartPointer<vtkActor> actor_of(const Geometry& geometry, const char* colour) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(geometry);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  const auto [red, green, blue] = rgb_of(colour);
  actor->GetProperty()->SetColor(red / 255.0, green / 255.0, blue / 255.0);
  actor->GetProperty()->SetInterpolationToPhong();
  actor->GetProperty()->SetAmbient(0.25);
  actor->GetProperty()->SetDiffuse(0.75);
  return actor;
}

/// The part of a segment within reach; nothing where there is none.
std::vector<glm::dvec3> within_reach(const glm::dvec3& from, const glm::dvec3& to) {
  const double box[6] = {-reach, reach, -reach, reach, -reach, reach};
  double t[2];
  glm::dvec3 ends[2];
  int sides[2];
  const int meets =
      vtkBox::IntersectWithLine(box, &from.x, &to.x, t[0], t[1], &ends[0].x, &ends[1].x, sides[0], sides[1]);
  if (meets == 0 || ends[0] == ends[1]) return {};
  return {ends[0], ends[1]};
}

/// The axis of the world that points up most as the stage is seen.
glm::dvec3 upright_axis(const StageCamera& camera) {
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(camera.up[i]) > std::abs(camera.up[axis])) axis = i;
  }
  glm::dvec3 up(0);
  up[axis] = camera.up[axis] < 0 ? -1 : 1;
  return up;
}

/// The middle of what the points take up as they are seen.
glm::dvec3 middle_of(const std::vector<glm::dvec3>& points, const StageCamera& camera) {
  glm::dvec3 middle(0);
  for (const glm::dvec3& axis : {camera.right, camera.up, camera.toward}) {
    const auto along = [&](const glm::dvec3& a, const glm::dvec3& b) {
      return glm::dot(a, axis) < glm::dot(b, axis);
    };
    const auto [least, most] = std::minmax_element(points.begin(), points.end(), along);
    middle += 0.5 * (glm::dot(*least, axis) + glm::dot(*most, axis)) * axis;
  }
  return middle;
}

double line_radius(const ShownItem& shown) {
  const double plain = 0.0085;
  if (shown.item->role == Role::frame) return 0.4 * plain;
  if (shown.emphasis == Emphasis::bright) return 1.5 * plain;
  if (shown.emphasis == Emphasis::dimmed) return 0.7 * plain;
  return shown.item->role == Role::ray ? 1.25 * plain : 0.8 * plain;
}

}  // namespace

SpaceScene::SpaceScene(vtkRenderer& renderer, const Stage& stage, std::size_t step)
    : renderer_(renderer),
      view_(stage.steps.at(step).view),
      is_flat_(stage.camera.is_flat || stage.steps.at(step).is_apart) {
  renderer_.RemoveAllViewProps();
  const std::vector<ShownItem> shown = shown_in(stage, step);
  set_camera(stage, shown);
  for (const ShownItem& one : shown) add(one);
  if (!is_flat_) add_floor();
  renderer_.RemoveAllLights();
  vtkNew<vtkLightKit> lights;
  lights->AddLightsToRenderer(&renderer_);
}

glm::dvec3 SpaceScene::placed(const glm::dvec3& p) const { return (p - view_.centre) / view_.radius; }

std::vector<glm::dvec3> SpaceScene::placed(const StageItem& item) const {
  std::vector<glm::dvec3> points;
  for (const glm::dvec3& p : item.points) {
    const glm::dvec3 q = placed(p);
    if (points.empty() || q != points.back()) points.push_back(q);
  }
  return points;
}

void SpaceScene::set_camera(const Stage& stage, const std::vector<ShownItem>& shown) {
  up_ = is_flat_ ? stage.camera.up : upright_axis(stage.camera);
  toward_ = stage.camera.toward;
  if (!is_flat_) {
    const glm::dvec3 level = glm::normalize(toward_ - glm::dot(toward_, up_) * up_);
    toward_ = std::cos(radians(elevation)) * level + std::sin(radians(elevation)) * up_;
  }
  const double half = std::tan(radians(view_angle / 2));
  glm::dvec3 middle(0);
  distance_ = margin / half;
  if (!is_flat_) {
    const glm::dvec3 right = glm::normalize(glm::cross(up_, toward_));
    const StageCamera turned{right, glm::cross(toward_, right), toward_};
    const std::vector<glm::dvec3> points = points_in_view(stage.camera, turned, shown);
    middle = middle_of(points, turned);
    distance_ = 0;
    for (const glm::dvec3& p : points) {
      const glm::dvec3 q = p - middle;
      const double size =
          std::max(std::abs(glm::dot(q, turned.right)) / view_aspect, std::abs(glm::dot(q, turned.up)));
      distance_ = std::max(distance_, margin * size / half + glm::dot(q, toward_));
    }
  }
  eye_ = middle + distance_ * toward_;
  vtkCamera& camera = *renderer_.GetActiveCamera();
  camera.SetFocalPoint(middle.x, middle.y, middle.z);
  camera.SetPosition(eye_.x, eye_.y, eye_.z);
  camera.SetViewUp(up_.x, up_.y, up_.z);
  camera.SetViewAngle(view_angle);
  camera.SetParallelProjection(is_flat_ ? 1 : 0);
  camera.SetParallelScale(margin);
  camera.SetClippingRange(0.2 * distance_, distance_ + 2 * reach);
}

std::vector<glm::dvec3> SpaceScene::points_in_view(const StageCamera& chosen, const StageCamera& turned,
                                                   const std::vector<ShownItem>& shown) const {
  constexpr double a_little_more = 1.05;
  std::vector<glm::dvec3> points;
  for (const ShownItem& one : shown) {
    for (const glm::dvec3& p : extent_of(*one.item, turned)) {
      const glm::dvec3 q = placed(p);
      const bool is_in = std::abs(glm::dot(q, chosen.right)) <= a_little_more * view_aspect &&
                         std::abs(glm::dot(q, chosen.up)) <= a_little_more && glm::length(q) <= reach;
      if (is_in) points.push_back(q);
    }
  }
  if (points.size() < 2) points = {chosen.up, -chosen.up};
  return points;
}

void SpaceScene::add_surface(const ShownItem& shown, const std::vector<glm::dvec3>& points) {
  const Form form = shown.item->form;
  const Geometry surface = form == Form::polygon     ? polygon_of(points)
                           : form == Form::ellipsoid ? ellipsoid_of(points)
                                                     : hull_of(points);
  const char* const colour = colour_of(shown_role(shown)).light;
  const auto body = actor_of(surface, colour);
  const bool is_dimmed = shown.emphasis == Emphasis::dimmed;
  body->GetProperty()->SetOpacity(is_dimmed ? 0.12 : form == Form::polygon ? 0.4 : 0.2);
  body->GetProperty()->SetSpecular(is_dimmed ? 0 : 0.25);
  body->GetProperty()->SetSpecularPower(30);
  if (is_flat_) body->GetProperty()->LightingOff();
  renderer_.AddActor(body);
  const Geometry rim = silhouette_of(surface, eye_, line_radius(shown));
  renderer_.AddActor(actor_of(rim, colour));
}

void SpaceScene::add(const ShownItem& shown) {
  const StageItem& item = *shown.item;
  const std::vector<glm::dvec3> points = placed(item);
  const char* const colour = colour_of(shown_role(shown)).light;
  const double radius = line_radius(shown);
  switch (item.form) {
    case Form::point: {
      if (!has_mark(item.role) || glm::length(points[0]) > reach) return;
      const double size = shown.emphasis == Emphasis::bright ? 0.034 : 0.027;
      renderer_.AddActor(actor_of(mark_of(mark_of(item.role), points[0], size, toward_), colour));
      return;
    }
    case Form::arrow:
    case Form::segment:
    case Form::polyline:
      for (std::size_t i = 0; i + 1 < points.size() && item.form != Form::polyline; ++i) {
        const std::vector<glm::dvec3> part = within_reach(points[i], points[i + 1]);
        if (part.empty()) continue;
        const bool has_head = item.form == Form::arrow && part[1] == points[1];
        renderer_.AddActor(actor_of(
            has_head ? arrow_of(part[0], part[1], radius) : tube_of(part, radius, item.pattern), colour));
      }
      if (item.form == Form::polyline && points.size() > 1) {
        const bool is_near = std::all_of(points.begin(), points.end(),
                                         [](const glm::dvec3& p) { return glm::length(p) < reach; });
        // Of the shape's own lines the far ones are seen through it, not dashed.
        const Pattern pattern =
            item.role == Role::surface || item.role == Role::frame ? Pattern::solid : item.pattern;
        if (is_near) renderer_.AddActor(actor_of(tube_of(points, radius, pattern), colour));
      }
      return;
    case Form::polygon:
    case Form::hull:
    case Form::ellipsoid:
      add_surface(shown, points);
  }
}

void SpaceScene::add_floor() {
  const std::vector<vtkActor*> all = [&] {
    std::vector<vtkActor*> actors;
    vtkActorCollection& list = *renderer_.GetActors();
    list.InitTraversal();
    while (vtkActor* actor = list.GetNextActor()) actors.push_back(actor);
    return actors;
  }();
  const Floor floor = floor_under(all, up_, view_.centre, view_.radius);
  renderer_.AddActor(floor.ground);
  renderer_.AddActor(floor.grid);
  for (const auto& shadow : floor.shadows) renderer_.AddActor(shadow);
}

std::vector<Point> SpaceScene::seen(const StageItem& item, const PixelBox& frame) const {
  std::vector<Point> pixels;
  if (item.form == Form::ellipsoid) return pixels;
  for (glm::dvec3 p : placed(item)) {
    // What is behind the eye or far off has no place in the picture.
    if (!is_flat_ && glm::dot(eye_ - p, toward_) < 0.2 * distance_) continue;
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
