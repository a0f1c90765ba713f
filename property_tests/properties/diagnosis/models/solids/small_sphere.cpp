#include "properties/diagnosis/models/solids/small_sphere.hpp"

#include <algorithm>
#include <array>

#include "properties/claims/answers.hpp"

namespace rayproof::diagnosis {
namespace {

/// A sphere that holds the solid, and the lengths of its edges; none of a sphere.
struct Ball {
  glm::dvec3 middle;
  double radius;
  std::vector<double> edges{};
};

Ball round_edges(const glm::dvec3& corner, const std::array<glm::dvec3, 3>& edges) {
  const auto& [u, v, w] = edges;
  const glm::dvec3 middle = corner + 0.5 * (u + v + w);
  const std::array half{u + v + w, u + v - w, u - v + w, v + w - u};
  double radius = 0;
  for (const glm::dvec3& diagonal : half) radius = std::max(radius, glm::length(diagonal) / 2);
  return {middle, radius, {glm::length(u), glm::length(v), glm::length(w)}};
}

std::optional<Ball> ball_round(const Case& one) {
  if (const auto* sphere = shape_in<Sphere<double>>(one)) return Ball{sphere->center, sphere->radius};
  if (const auto* solid = shape_in<Parallelepiped<double>>(one))
    return round_edges(solid->corner, solid->edges);
  const auto* box = shape_in<Box<double>>(one);
  if (box == nullptr) return std::nullopt;
  const glm::dvec3 size = box->max - box->min;
  return round_edges(box->min, {glm::dvec3(size.x, 0, 0), {0, size.y, 0}, {0, 0, size.z}});
}

/// How far the line passes from the middle.
double distance_of_line(const Case& one, const glm::dvec3& middle) {
  const Ray<double> ray = ray_in_object(*ray_question(one));
  return glm::length(glm::cross(middle - ray.origin, glm::normalize(ray.direction)));
}

}  // namespace

Answers square_beside_radius(const Case& one, const Answer& exact) {
  const std::optional<Ball> ball = ball_round(one);
  if (!ball || !finds_something(exact)) return {};
  const double distance = distance_of_line(one, ball->middle);
  Answers answers;
  for (const bool is_beyond : {distance * distance > ball->radius, distance > ball->radius * ball->radius})
    answers.push_back(is_beyond ? Answer{RayAnswer{}} : exact);
  return answers;
}

Answers solid_beyond_small_sphere(const Case& one, const Answer& exact) {
  const std::optional<Ball> ball = ball_round(one);
  if (!ball || ball->edges.empty() || !finds_something(exact)) return {};
  const double distance = distance_of_line(one, ball->middle);
  Answers answers;
  for (const double radius :
       {std::ranges::max(ball->edges) / 2, std::ranges::min(ball->edges) / 2, ball->radius / 2})
    answers.push_back(distance > radius ? Answer{RayAnswer{}} : exact);
  return answers;
}

}  // namespace rayproof::diagnosis
