#include "properties/diagnosis/models/curved/wrong_chord.hpp"

#include <cmath>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/examination/agreement.hpp"

namespace rayproof::diagnosis {

Answers half_chord_as_radius(const Case& one, const Answer& /*exact*/) {
  const auto* sphere = shape_in<Sphere<double>>(one);
  if (sphere == nullptr) return {};
  const Ray<double>& given = ray_question(one)->ray;
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const double square = glm::dot(ray.direction, ray.direction);
  const double middle = glm::dot(sphere->center - ray.origin, ray.direction) / square;
  Answers answers;
  for (const double half : {sphere->radius / std::sqrt(square), sphere->radius, 1.0}) {
    RayAnswer line;
    for (const double t : {middle - half, middle + half}) {
      const bool is_again = line.hits.count > 0 && are_close(one.precision, line.hits.t[0], t, 0);
      if (in_interval(given, t) && !is_again) line.hits.push_back(t);
    }
    answers.emplace_back(line);
  }
  return answers;
}

Answers near_hits_of_sphere_missed(const Case& one, const Answer& exact) {
  const auto* sphere = shape_in<Sphere<double>>(one);
  if (sphere == nullptr || !finds_something(exact)) return {};
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const double length = glm::length(ray.direction), radius = sphere->radius;
  const auto& all = std::get<RayAnswer>(exact);
  Answers answers;
  for (const double least : {radius, 2 * radius})
    answers.emplace_back(hits_where(all, [&](double t) { return t * length >= least; }));
  const bool is_near = glm::distance(sphere->center, ray.origin) < radius + length;
  answers.emplace_back(is_near ? RayAnswer{} : all);
  return answers;
}

bool starts_outside_of_sphere(const Case& one, const Answer& exact) {
  const auto* sphere = shape_in<Sphere<double>>(one);
  const auto* hits = std::get_if<RayAnswer>(&exact);
  if (sphere == nullptr || hits == nullptr || hits->hits.count == 0) return false;
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const HitList line = hits_of_line(one).hits;
  // A search along the ray, too, may leave out what is near the surface, barely hit, or small.
  const bool is_clear =
      sphere->radius > 0.25 && glm::distance(sphere->center, ray.origin) > 1.125 * sphere->radius;
  return is_clear && line.count > 1 && hits->hits.t[0] > 0 &&
         (line.t[1] - line.t[0]) * glm::length(ray.direction) > sphere->radius;
}

}  // namespace rayproof::diagnosis
