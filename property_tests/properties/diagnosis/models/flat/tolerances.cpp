#include "properties/diagnosis/models/flat/tolerances.hpp"

#include <glm/vector_relational.hpp>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/outlines/outline_geometry.hpp"

namespace rayproof::diagnosis {
namespace {

/// Where the line meets a triangle's plane: t, the barycentric coordinates, and the triangle's area.
struct WeightedHit {
  double t;
  glm::dvec3 weights;
  double area;
};

std::optional<WeightedHit> hit_of_plane(const Case& one) {
  const auto figure = flat_figure(one);
  const auto hit = plane_hit(one);
  if (shape_in<Triangle<double>>(one) == nullptr || !hit) return std::nullopt;
  const glm::dvec2 a = hit->vertices[0], b = hit->vertices[1], c = hit->vertices[2];
  const double whole = turn(a, b, c);
  const double beta = turn(a, hit->point, c) / whole, gamma = turn(a, b, hit->point) / whole;
  return WeightedHit{hit->t, {1 - beta - gamma, beta, gamma}, glm::length(figure->normal) / 2};
}

double sum_of_sizes(const glm::dvec3& weights) {
  const glm::dvec3 sizes = glm::abs(weights);
  return sizes.x + sizes.y + sizes.z;
}

}  // namespace

Answers within_weights(const Case& one, const Answer& exact, double least) {
  const auto hit = hit_of_plane(one);
  if (!hit || finds_something(exact) == (least < 0)) return {};
  const auto& [t, weights, area] = *hit;
  const Answer by_all = hit_at(one, t, glm::all(glm::greaterThanEqual(weights, glm::dvec3(least)))).front();
  // The least change first where hits are lost; where they are gained, the tolerance that is met most.
  Answers answers;
  if (least < 0) answers.push_back(by_all);
  for (int vertex = 0; vertex < 3; ++vertex) {
    glm::dvec3 least_of_each(0);
    least_of_each[vertex] = least;
    answers.push_back(hit_at(one, t, glm::all(glm::greaterThanEqual(weights, least_of_each))).front());
  }
  answers.push_back(least < 0 ? hit_at(one, t, sum_of_sizes(weights) <= 1 - least).front() : by_all);
  return answers;
}

Answers within_area(const Case& one, double more) {
  const auto hit = hit_of_plane(one);
  if (!hit) return {};
  return hit_at(one, hit->t, (sum_of_sizes(hit->weights) - 1) * hit->area <= more);
}

}  // namespace rayproof::diagnosis
