#include "properties/diagnosis/models/hits/starts.hpp"

#include <algorithm>
#include <cmath>

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

Answers missed_from_front(const Case& one, const Answer& exact) { return missed_from(one, exact, 1); }
Answers missed_from_back(const Case& one, const Answer& exact) { return missed_from(one, exact, -1); }

}  // namespace rayproof::diagnosis
