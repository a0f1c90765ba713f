#include "viz/shapes/ray_scene.hpp"

#include <algorithm>
#include <cmath>

#include "viz/explain/answers.hpp"
#include "viz/shapes/camera.hpp"

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

}  // namespace

StageCamera RayScene::camera() const {
  std::vector<glm::dvec3> normals;
  for (const Place& normal : figure.normals) {
    if (dot(normal, normal) != 0) normals.push_back(rounded(normal));
  }
  return chosen_camera(rounded(along_ray), normals);
}

RayScene scene_of(Figure (*maker)(const Sight&), const Case& one, const Answer* exact,
                  const Answer* claimed) {
  const auto& question = std::get<RayQuestion>(one.question);
  const Sight sight{question, World(question), convert<Shadow>(question.ray), first_hit(exact, claimed)};
  return {sight, maker(sight), unit(sight.ray.direction)};
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

}  // namespace rayproof::viz
