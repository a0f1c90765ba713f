#include "viz/shapes/ray_scene.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "viz/explain/case_report.hpp"
#include "viz/shapes/topics.hpp"

namespace rayproof::viz {
namespace {

std::optional<Shadow> first_hit(const Answer* exact, const Answer* claimed) {
  for (const Answer* answer : {exact, claimed}) {
    for (const double t : values_of(answer)) {
      if (std::isfinite(t)) return Shadow(t);
    }
  }
  return std::nullopt;
}

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

StageCamera RayScene::camera() const {
  std::vector<glm::dvec3> normals;
  for (const Place& normal : figure.normals) {
    if (dot(normal, normal) != 0) normals.push_back(rounded(normal));
  }
  return chosen_camera(rounded(along_ray), normals);
}

RayScene scene_of(const Case& one, const Answer* exact, const Answer* claimed) {
  const auto& question = std::get<RayQuestion>(one.question);
  const Sight sight{question, World(question), convert<Shadow>(question.ray), first_hit(exact, claimed)};
  return {sight, figure_of(sight), unit(sight.ray.direction)};
}

std::optional<NearestPass> nearest_of(const RayScene& scene) {
  const Ray<Shadow>& ray = scene.sight.ray;
  const auto across = [&](const Place& v) { return v - dot(v, scene.along_ray) * scene.along_ray; };
  std::optional<NearestPass> nearest;
  for (const Border& border : scene.figure.borders) {
    const auto& [from, to] = border.line;
    const Place side = across(to - from);
    const Shadow square = dot(side, side);
    const Shadow part = square == 0 ? Shadow(0) : Shadow(-dot(across(from - ray.origin), side) / square);
    const Place on_outline = from + std::clamp<Shadow>(part, 0, 1) * (to - from);
    const Shadow t = dot(on_outline - ray.origin, scene.along_ray) / length(ray.direction);
    const Shadow gap = length(on_outline - scene.at(t));
    if (in_interval(ray, t) && (!nearest || gap < nearest->gap)) nearest = {&border, t, on_outline, gap};
  }
  return nearest;
}

StageCamera chosen_camera(const glm::dvec3& along_ray, const std::vector<glm::dvec3>& normals) {
  static const std::vector<glm::dvec3> candidates = all_around();
  const auto best = std::ranges::max_element(candidates, [&](const auto& a, const auto& b) {
    return score(a, along_ray, normals) < score(b, along_ray, normals);
  });
  const glm::dvec3 toward = glm::normalize(*best);
  const glm::dvec3 right = glm::normalize(along_ray - glm::dot(along_ray, toward) * toward);
  return {right, glm::cross(toward, right), toward};
}

}  // namespace rayproof::viz
