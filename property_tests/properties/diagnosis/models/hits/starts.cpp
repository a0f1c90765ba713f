#include "properties/diagnosis/models/hits/starts.hpp"

#include <algorithm>
#include <cmath>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/plane_hit.hpp"

namespace rayproof::diagnosis {
namespace {

/// A miss where the origin lies on that side of the surface: 1 for where the normal points.
Answers missed_from(const Case& one, const Answer& exact, double side) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (answer == nullptr || !answer->normal || !lies_in_a_plane(one)) return {};
  const double above = -answer->hits.t[0] * glm::dot(*answer->normal, ray_question(one)->ray.direction);
  return side * above > 0 ? Answers{RayAnswer{}} : Answers{};
}

}  // namespace

Answers missed_with_middle_behind(const Case& one, const Answer& exact) {
  const RayQuestion* asked = ray_question(one);
  // Of spheres another model speaks.
  if (asked == nullptr || !finds_something(exact) || shape_in<Sphere<double>>(one) != nullptr) return {};
  const auto middle = middle_of(asked->shape);
  const Ray<double> ray = ray_in_object(*asked);
  const bool is_behind = middle && glm::dot(*middle - ray.origin, ray.direction) < 0;
  return is_behind ? Answers{RayAnswer{}} : Answers{};
}

Answers missed_from_front(const Case& one, const Answer& exact) { return missed_from(one, exact, 1); }
Answers missed_from_back(const Case& one, const Answer& exact) { return missed_from(one, exact, -1); }

}  // namespace rayproof::diagnosis
