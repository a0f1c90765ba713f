#include "viz/shapes/camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace rayproof::viz {
namespace {

/// Directions spread evenly over all sides.
std::vector<glm::dvec3> all_around() {
  constexpr int count = 600;
  std::vector<glm::dvec3> directions;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count;
    const double across = std::sqrt(1 - z * z);
    const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    directions.emplace_back(across * std::cos(angle), across * std::sin(angle), z);
  }
  return directions;
}

/// How well the ray and the worst seen surface are seen, 1 being well enough; among equals, the world's z
/// axis rather points up, and the eye is rather in front of the first surface.
double score(const glm::dvec3& toward, const glm::dvec3& ray, const std::vector<glm::dvec3>& normals) {
  const double along = dot(toward, ray);
  const double ray_seen = std::sqrt(std::max(0.0, 1 - along * along));
  double seen = std::min(1.0, ray_seen / 0.8);
  for (const glm::dvec3& normal : normals) {
    const double facing = std::abs(dot(toward, normal));
    const double enough = normals.size() > 1 ? 0.35 : 0.5;
    seen = std::min({seen, facing / enough, normals.size() > 1 ? (1 - facing) / 0.12 : 1.0});
  }
  const glm::dvec3 right = (ray - along * toward) / std::max(ray_seen, 1e-3);
  const double z_up = cross(toward, right).z;
  const double in_front = normals.empty() ? 0 : dot(toward, normals.front());
  return seen + 0.06 * z_up + 0.02 * in_front;
}

}  // namespace

StageCamera chosen_camera(const glm::dvec3& along_ray, const std::vector<glm::dvec3>& normals) {
  static const std::vector<glm::dvec3> candidates = all_around();
  const auto best = std::max_element(candidates.begin(), candidates.end(), [&](const auto& a, const auto& b) {
    return score(a, along_ray, normals) < score(b, along_ray, normals);
  });
  const glm::dvec3 toward = glm::normalize(*best);
  const glm::dvec3 right = glm::normalize(along_ray - glm::dot(along_ray, toward) * toward);
  return {right, glm::cross(toward, right), toward};
}

}  // namespace rayproof::viz
