#include "viz/flat/stage_picture.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <utility>

#include "viz/scene/items.hpp"

namespace rayproof::viz {
namespace {

WorldLine rim_of(const StageItem& ellipsoid, const StageCamera& camera) {
  constexpr int sides = 96;
  WorldLine rim;
  for (int i = 0; i <= sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    rim.push_back(farthest_of(ellipsoid, std::cos(angle) * camera.right + std::sin(angle) * camera.up));
  }
  return rim;
}

struct Face {
  glm::dvec3 normal{0};  ///< outward, of unit length or 0
  bool is_front = false;
};

Face face_of(const WorldLine& ring, const glm::dvec3& middle, const glm::dvec3& toward) {
  Face face;
  for (std::size_t i = 0; i < ring.size(); ++i)
    face.normal += glm::cross(ring[i] - middle, ring[(i + 1) % ring.size()] - middle);
  const double size = glm::length(face.normal);
  if (size > 0) face.normal /= glm::dot(face.normal, ring.front() - middle) < 0 ? -size : size;
  face.is_front = glm::dot(face.normal, toward) > 0;
  return face;
}

SurfaceOutline solid_outline(const StageItem& solid, const StageCamera& camera) {
  constexpr double sharp = 0.866;  // faces more than 30° apart do not look like one round side
  glm::dvec3 middle(0);
  for (const glm::dvec3& p : solid.points) middle += p / static_cast<double>(solid.points.size());
  SurfaceOutline outline;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Face>> edges;
  for (const auto& corners : solid.faces) {
    WorldLine ring;
    for (const std::size_t i : corners) ring.push_back(solid.points[i]);
    const Face face = face_of(ring, middle, camera.toward);
    for (std::size_t i = 0; i < corners.size(); ++i)
      edges[std::minmax(corners[i], corners[(i + 1) % corners.size()])].push_back(face);
    if (face.is_front) outline.filled.push_back(std::move(ring));
  }
  for (const auto& [ends, faces] : edges) {
    const Face& one = faces.front();
    const Face& other = faces.back();
    const WorldLine line{solid.points[ends.first], solid.points[ends.second]};
    const bool is_sharp = glm::dot(one.normal, other.normal) < sharp;
    if (is_sharp || one.is_front != other.is_front)
      (one.is_front || other.is_front ? outline.seen : outline.hidden).push_back(line);
  }
  return outline;
}

}  // namespace

SurfaceOutline surface_outline(const StageItem& surface, const StageCamera& camera) {
  if (surface.form == Form::polygon) return {{surface.points}};
  if (surface.form == Form::solid) return solid_outline(surface, camera);
  const WorldLine rim = rim_of(surface, camera);
  return {{rim}, {rim}};
}

}  // namespace rayproof::viz
