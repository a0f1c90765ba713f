#include "properties/diagnosis/models/starts.hpp"

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

Answers far_hit_beyond(const Case& one, const Answer& /*exact*/) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr) return {};
  const RayAnswer line = hits_of_line(one);
  const auto& hits = line.hits;
  if (hits.count < 2 || !(hits.t[0] < asked->ray.t_min) || !(asked->ray.t_max < hits.t[1])) return {};
  return {hits_where(line, [&](double t) { return t == hits.t[1]; })};
}

Answers behind_origin_missed(const Case& one, const Answer& exact) {
  if (ray_question(one) == nullptr || std::get<RayAnswer>(exact).hits.count == 0) return {};
  const HitList hits = hits_of_line(one).hits;
  return hits.t.at(hits.count - 1) < 0 ? Answers{RayAnswer{}} : Answers{};
}

Answers missed_from_front(const Case& one, const Answer& exact) { return missed_from(one, exact, 1); }
Answers missed_from_back(const Case& one, const Answer& exact) { return missed_from(one, exact, -1); }

}  // namespace rayproof::diagnosis
