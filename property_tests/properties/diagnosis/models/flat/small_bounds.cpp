#include "properties/diagnosis/models/flat/small_bounds.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "properties/claims/answers.hpp"

namespace rayproof::diagnosis {
namespace {

double distance_from_line(const Ray<double>& ray, const glm::dvec3& point) {
  return glm::length(glm::cross(point - ray.origin, glm::normalize(ray.direction)));
}

}  // namespace

Answers beyond_small_sphere(const Case& one, const Answer& exact) {
  const auto* triangle = shape_in<Triangle<double>>(one);
  if (triangle == nullptr || !finds_something(exact)) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const std::array all{triangle->a, triangle->b, triangle->c};
  const glm::dvec3 middle = (all[0] + all[1] + all[2]) / 3.0;
  Answers answers;
  const auto try_sphere = [&](const glm::dvec3& centre, double radius) {
    answers.push_back(distance_from_line(ray, centre) > radius ? Answer{RayAnswer{}} : exact);
  };
  for (std::size_t left_out = 0; left_out < all.size(); ++left_out) {
    const glm::dvec3 &p = all[(left_out + 1) % 3], &q = all[(left_out + 2) % 3];
    const double to_p = glm::distance(middle, p), to_q = glm::distance(middle, q);
    try_sphere(0.5 * (p + q), glm::distance(p, q) / 2);
    try_sphere(middle, std::max(to_p, to_q));
    try_sphere(middle, to_p);
  }
  return answers;
}

Answers polygon_beyond_small_sphere(const Case& one, const Answer& exact) {
  const auto* polygon = shape_in<Polygon<double>>(one);
  if (polygon == nullptr || !finds_something(exact)) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const glm::dvec3 hit = point_at(ray, std::get<RayAnswer>(exact).hits.t[0]);
  const auto& v = polygon->vertices;
  const glm::dvec3 mean = mean_of(v);
  std::vector<double> from_mean;
  for (const glm::dvec3& vertex : v) from_mean.push_back(glm::distance(vertex, mean));
  const double sum = std::accumulate(from_mean.begin(), from_mean.end(), 0.0);
  const double first = glm::distance(v[0], v[1]), second = glm::distance(v[1], v[2]);
  const double diagonal = glm::distance(v[0], v[2]), last = glm::distance(v.back(), v[0]);
  Answers answers;
  const auto try_sphere = [&](const glm::dvec3& centre, double radius) {
    for (const double way : {glm::distance(hit, centre), distance_from_line(ray, centre)})
      answers.push_back(way > radius ? Answer{RayAnswer{}} : exact);
  };
  for (const double radius :
       {first + second, first + last, std::max(first, last), std::max(first, diagonal), first, last})
    try_sphere(v[0], radius);
  for (const double radius : {std::ranges::max(from_mean) / 2, sum / static_cast<double>(v.size()),
                              std::ranges::min(from_mean), from_mean.front()})
    try_sphere(mean, radius);
  return answers;
}

}  // namespace rayproof::diagnosis
