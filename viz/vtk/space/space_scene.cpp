#include "viz/vtk/space/space_scene.hpp"

#include <vtkActorCollection.h>
#include <vtkAppendPolyData.h>
#include <vtkCamera.h>
#include <vtkLightKit.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <tuple>

#include "viz/flat/stage_picture.hpp"
#include "viz/vtk/space/geometry.hpp"

namespace rayproof::viz {
namespace {

/// Lit pixel by pixel, or at the corners of its facets alone.
vtkSmartPointer<vtkActor> lit_actor(const Geometry& geometry, Role role, bool is_fine) {
  auto actor = actor_of(geometry, colour_of(role));
  vtkProperty& property = *actor->GetProperty();
  is_fine ? property.SetInterpolationToPhong() : property.SetInterpolationToGouraud();
  property.SetAmbient(0.25);
  property.SetDiffuse(0.75);
  return actor;
}

/// How many times wider than high the renderer's part of its window is.
double aspect_of(vtkRenderer& renderer) {
  const int* const size = renderer.GetRenderWindow()->GetSize();
  const double* const port = renderer.GetViewport();
  return (port[2] - port[0]) * size[0] / ((port[3] - port[1]) * size[1]);
}

void set_camera(vtkCamera& camera, const SpaceCamera& view) {
  const glm::dvec3 at = view.eye();
  camera.SetFocalPoint(view.middle.x, view.middle.y, view.middle.z);
  camera.SetPosition(at.x, at.y, at.z);
  camera.SetViewUp(view.up.x, view.up.y, view.up.z);
  camera.SetViewAngle(view_angle);
  camera.SetParallelProjection(view.is_flat ? 1 : 0);
  camera.SetParallelScale(view.half);
  camera.SetClippingRange(view.nearest(), view.farthest());
}

/// The part of a line before the eye: what is behind it has no place in the picture.
SpacePoints before_eye(const SpacePoints& line, const SpaceCamera& camera) {
  if (camera.is_flat) return line;
  const auto depth = [&](const glm::dvec3& p) {
    return glm::dot(camera.eye() - p, camera.toward) - camera.nearest();
  };
  SpacePoints part;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double here = depth(line[i]), last = i > 0 ? depth(line[i - 1]) : here;
    if ((here < 0) != (last < 0)) part.push_back(glm::mix(line[i - 1], line[i], last / (last - here)));
    if (here >= 0) part.push_back(line[i]);
  }
  return part;
}

}  // namespace

void prepare_for_space(vtkRenderWindow& window) {
  window.SetMultiSamples(0);  // as depth peeling wants it
  window.SetAlphaBitPlanes(1);
  window.SetDPI(72);
}

void set_fine(vtkRenderer& renderer, bool is_fine) {
  // VTK 9.1's dual depth peeling leaves out the far side of some bodies under software rendering.
  setenv("VTK_USE_LEGACY_DEPTH_PEELING", "1", 1);
  renderer.SetMaximumNumberOfPeels(6);
  renderer.SetOcclusionRatio(0.02);
  renderer.SetUseDepthPeeling(is_fine ? 1 : 0);
  renderer.SetUseFXAA(is_fine);
}

SpaceScene::SpaceScene(vtkRenderer& renderer, const Stage& stage, std::size_t step, Look look, int sides)
    : renderer_(renderer), space_(space_of(stage, step, aspect_of(renderer))), sides_(sides) {
  renderer_.RemoveAllViewProps();
  place_camera(look);
  for (const SpaceBody& body : space_.bodies) {
    if (body.is_mark()) {
      add_mark(body);
    } else if (body.is_surface()) {
      add_surface(body);
    } else {
      parts_.push_back({SpacePart::Kind::line, shown_role(body.shown),
                        line_geometry(body.pieces, body.head, body.radius, sides_)});
    }
  }
  // Each actor costs VTK a shader a frame.
  for (const SpacePart& part : is_fine() ? parts_ : merged(parts_)) add_actor(part);
  if (space_.floor) add_floor();
  if (!is_fine()) blend_films();
  renderer_.RemoveAllLights();
  vtkNew<vtkLightKit> lights;
  lights->AddLightsToRenderer(&renderer_);
}

void SpaceScene::place_camera(Look look) {
  vtkCamera& camera = *renderer_.GetActiveCamera();
  if (look == Look::anew) return set_camera(camera, space_.camera);
  SpaceCamera turned = space_.camera;
  camera.GetViewUp(&turned.up.x);
  camera.GetViewPlaneNormal(&space_.camera.toward.x);
  turned.toward = space_.camera.toward;
  if (look == Look::from_same_side) return set_camera(camera, turned);
  camera.GetFocalPoint(&space_.camera.middle.x);
  space_.camera.distance = camera.GetDistance();
  camera.SetClippingRange(space_.camera.nearest(), space_.camera.farthest());
}

void SpaceScene::add_mark(const SpaceBody& body) {
  // In a drawing what comes later stands before what was there, and marks before lines.
  const glm::dvec3& at = body.points.at(0);
  const bool is_flat = space_.camera.is_flat;
  const double height = is_flat ? 0.1 + 0.01 * static_cast<double>(parts_.size()) : 0;
  const glm::dvec3 place = at + height * space_.camera.toward;
  const Geometry mark =
      mark_geometry(mark_of(body.shown.item->role), place, body.radius, space_.camera, sides_);
  parts_.push_back({SpacePart::Kind::mark, shown_role(body.shown), mark});
  // So far toward the eye that the line or surface on which it lies does not cut it.
  if (!is_flat) parts_.back().shift = 2 * body.radius * glm::normalize(space_.camera.eye() - at);
}

void SpaceScene::add_surface(const SpaceBody& body) {
  const Form form = body.shown.item->form;
  const Geometry surface = form == Form::polygon     ? polygon_of(body.points, body.strips)
                           : form == Form::ellipsoid ? ellipsoid_of(body.points, sides_)
                                                     : solid_of(body.points, body.shown.item->faces);
  const bool is_polygon = form == Form::polygon;
  parts_.push_back({is_polygon ? SpacePart::Kind::polygon : SpacePart::Kind::closed, shown_role(body.shown),
                    surface, body.opacity, body.shown.emphasis == Emphasis::dimmed ? 0 : 0.25});
  if (body.radius == 0) return;
  const Geometry outline = is_polygon ? ring_of(body.points, body.radius, sides_)
                                      : silhouette_of(surface, space_.camera.eye(), body.radius, sides_);
  parts_.push_back({SpacePart::Kind::line, shown_role(body.shown), outline});
}

std::vector<SpaceScene::SpacePart> SpaceScene::merged(const std::vector<SpacePart>& parts) {
  std::vector<SpacePart> few;
  std::vector<vtkSmartPointer<vtkAppendPolyData>> together;
  for (const SpacePart& part : parts) {
    const auto same = std::ranges::find_if(few, [&](const SpacePart& other) {
      return std::tie(part.kind, part.role, part.opacity, part.specular) ==
             std::tie(other.kind, other.role, other.opacity, other.specular);
    });
    const auto place = static_cast<std::size_t>(same - few.begin());
    if (same == few.end()) {
      few.push_back(part);
      few.back().shift = {};
      together.push_back(vtkSmartPointer<vtkAppendPolyData>::New());
    }
    together[place]->AddInputData(part.geometry);
  }
  for (std::size_t i = 0; i < few.size(); ++i) {
    together[i]->Update();
    few[i].geometry = together[i]->GetOutput();
  }
  return few;
}

void SpaceScene::add_actor(const SpacePart& part) {
  const auto actor = lit_actor(part.geometry, part.role, is_fine());
  actor->SetPosition(part.shift.x, part.shift.y, part.shift.z);
  renderer_.AddActor(actor);
  if (space_.camera.is_flat) actor->GetProperty()->LightingOff();
  if (part.kind == SpacePart::Kind::line || part.kind == SpacePart::Kind::mark) return;
  vtkProperty& property = *actor->GetProperty();
  property.SetOpacity(part.opacity);
  property.SetSpecular(part.specular);
  property.SetSpecularPower(30);
  films_.emplace_back(actor);
  if (part.kind == SpacePart::Kind::closed) closed_.emplace_back(actor);
}

void SpaceScene::blend_films() {
  for (vtkActor* film : films_) {
    renderer_.RemoveActor(film);
    renderer_.AddActor(film);
    film->ForceOpaqueOn();
  }
  for (vtkActor* film : closed_) {
    const double clear = 1 - film->GetProperty()->GetOpacity();
    film->GetProperty()->SetOpacity(1 - clear * clear);  // its far side is not drawn
    film->GetProperty()->BackfaceCullingOn();
  }
}

void SpaceScene::add_floor() {
  std::vector<vtkActor*> actors;
  vtkActorCollection& all = *renderer_.GetActors();
  all.InitTraversal();
  while (vtkActor* actor = all.GetNextActor()) actors.push_back(actor);
  const Floor floor = floor_under(actors, *space_.floor);
  renderer_.AddActor(floor.ground);
  renderer_.AddActor(floor.grid);
  for (const auto& shadow : floor.shadows) renderer_.AddActor(shadow);
}

std::vector<Point> SpaceScene::seen(const StageItem& item, const PixelBox& frame) const {
  std::vector<Point> pixels;
  SpacePoints points = placed_points(item, space_.view);
  if (item.form == Form::ellipsoid) {
    // Its outline as it is seen from afar.
    const glm::dvec3 right = glm::normalize(glm::cross(space_.camera.up, space_.camera.toward));
    const StageCamera camera{right, glm::cross(space_.camera.toward, right), space_.camera.toward};
    StageItem placed = item;
    placed.points = points;
    points = surface_outline(placed, camera).seen.front();
  }
  for (const glm::dvec3& p : before_eye(points, space_.camera)) {
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
