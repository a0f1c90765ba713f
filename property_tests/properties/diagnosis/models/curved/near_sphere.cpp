#include "properties/diagnosis/models/curved/near_sphere.hpp"

#include <glm/geometric.hpp>

#include "properties/claims/answers.hpp"

namespace rayproof::diagnosis {
namespace {

/// The origin seen from the centre, the direction, and the radius.
struct SeenFromCentre {
  glm::dvec3 origin, direction;
  double radius;
};

std::optional<SeenFromCentre> seen_from_centre(const Case& one) {
  const auto* sphere = shape_in<Sphere<double>>(one);
  if (sphere == nullptr) return std::nullopt;
  const Ray<double> ray = ray_in_object(*ray_question(one));
  return SeenFromCentre{ray.origin - sphere->center, ray.direction, sphere->radius};
}

}  // namespace

Answers passing_near_rim_missed(const Case& one, const Answer& exact) {
  const auto seen = seen_from_centre(one);
  if (!seen || !finds_something(exact)) return {};
  const double distance =
      glm::length(glm::cross(seen->origin, seen->direction)) / glm::length(seen->direction);
  Answers answers;
  for (const double share : {1e-2, 1e-3, 1e-4, 1e-5}) {
    const bool is_near_rim = distance > seen->radius - share * glm::length(seen->origin);
    answers.push_back(is_near_rim ? Answer{RayAnswer{}} : exact);
  }
  return answers;
}

bool passes_below_surface(const Case& one, const Answer& /*exact*/) {
  const auto seen = seen_from_centre(one);
  const HitList line = hits_of_line(one).hits;
  return seen && line.count > 1 &&
         (line.t[1] - line.t[0]) * glm::length(seen->direction) > 0x1p-5 * seen->radius;
}

Answers far_hit_from_near(const Case& one, const Answer& exact) {
  const auto seen = seen_from_centre(one);
  if (!seen) return {};
  const RayAnswer line = hits_of_line(one);
  Answers answers;
  for (const double share : {0.2, 0.1, 0.05, 0.02, 0.01, 1e-3, 1e-4}) {
    const bool is_near = glm::length(seen->origin) < (1 + share) * seen->radius;
    RayAnswer far;
    if (line.hits.count > 1 && in_interval(ray_question(one)->ray, line.hits.t[1]))
      far.hits.push_back(line.hits.t[1]);
    answers.push_back(is_near && line.hits.count > 1 ? Answer{far} : exact);
  }
  return answers;
}

bool starts_outside(const Case& one, const Answer& /*exact*/) {
  const auto seen = seen_from_centre(one);
  return seen && glm::length(seen->origin) > seen->radius;
}

Answers far_centre_missed(const Case& one, const Answer& exact, double limit) {
  const auto* sphere = shape_in<Sphere<double>>(one);
  if (sphere == nullptr || !finds_something(exact)) return {};
  const double far = glm::distance(ray_in_object(*ray_question(one)).origin, sphere->center);
  return far > limit ? Answers{RayAnswer{}} : Answers{};
}

bool has_hit_within(const Answer& exact, double limit) {
  const std::vector<double> all = numbers_in(exact);
  return !all.empty() && all.front() < limit / 2;
}

}  // namespace rayproof::diagnosis
