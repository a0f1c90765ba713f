#include "viz/shapes/figure.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "viz/explain/case_report.hpp"
#include "viz/shapes/topics.hpp"

namespace rayproof::viz {
namespace {

/// What of v is at right angles to a unit vector.
Place part_across(const Place& v, const Place& along) { return v - dot(v, along) * along; }

std::optional<Shadow> first_hit(const Answer* exact, const Answer* claimed) {
  for (const Answer* answer : {exact, claimed}) {
    for (const double t : values_of(answer)) {
      if (std::isfinite(t)) return Shadow(t);
    }
  }
  return std::nullopt;
}

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

World::World(const RayQuestion& question) : x_{1, 0, 0}, y_{0, 1, 0}, z_{0, 0, 1}, translation_{0, 0, 0} {
  if (!question.transform) return;
  const auto column = [&](int i) { return convert<Shadow>(glm::dvec3((*question.transform)[i])); };
  x_ = column(0);
  y_ = column(1);
  z_ = column(2);
  translation_ = column(3);
}

Figure flat_figure(const std::vector<Place>& vertices, const Place& normal,
                   const std::vector<std::string>& names) {
  Figure figure;
  figure.points = vertices;
  figure.normals = {unit(normal)};
  figure.faces.emplace_back();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Place& from = vertices[i];
    const Place& to = vertices[(i + 1) % vertices.size()];
    figure.faces[0].push_back(i);
    figure.borders.push_back({{from, to}, {unit(cross(normal, to - from))}});
    if (i < names.size()) figure.labels.emplace_back(names[i], from);
  }
  return figure;
}

Figure solid_figure(const Place& corner, const std::array<Place, 3>& edges) {
  Figure figure;
  // Bit i of a corner's number is set at the far end of edges[i].
  for (unsigned set = 0; set < 8; ++set) {
    Place place = corner;
    for (unsigned i = 0; i < 3; ++i) {
      if ((set >> i & 1U) != 0) place = place + edges[i];
    }
    figure.points.push_back(place);
  }
  for (unsigned axis = 0; axis < 3; ++axis) {
    const unsigned one = 1U << (axis + 1) % 3;
    const unsigned other = 1U << (axis + 2) % 3;
    const Place& u = edges[(axis + 1) % 3];
    const Place& v = edges[(axis + 2) % 3];
    const Place along = unit(edges[axis]);
    figure.normals.push_back(unit(cross(u, v)));
    for (const unsigned near : {0U, 1U << axis}) {
      figure.faces.push_back({near, near | one, near | one | other, near | other});
    }
    for (const unsigned foot : {0U, one, one | other, other}) {
      const Place into_u = (foot & one) != 0 ? Place(Shadow(-1) * u) : u;
      const Place into_v = (foot & other) != 0 ? Place(Shadow(-1) * v) : v;
      figure.borders.push_back({{figure.points[foot], figure.points[foot | 1U << axis]},
                                {unit(part_across(into_u, along)), unit(part_across(into_v, along))}});
    }
  }
  return figure;
}

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
