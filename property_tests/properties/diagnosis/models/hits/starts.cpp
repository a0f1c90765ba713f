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

std::optional<bool> beyond_end_by_rounding(const Case& one, const Answer& got, const Answer& /*exact*/) {
  constexpr double few = 8;
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr) return std::nullopt;
  const double unit = roundoff_of(one.precision);
  const auto is_beyond = [&](double t) {
    const double end = t < asked->ray.t_min ? asked->ray.t_min : asked->ray.t_max;
    return !in_interval(asked->ray, t) && std::abs(t - end) <= few * unit * std::abs(end);
  };
  const HitList& hits = std::get<RayAnswer>(got).hits;
  return std::ranges::any_of(hits.view(), is_beyond) ? std::optional(true) : std::nullopt;
}

Answers missed_from_front(const Case& one, const Answer& exact) { return missed_from(one, exact, 1); }
Answers missed_from_back(const Case& one, const Answer& exact) { return missed_from(one, exact, -1); }

}  // namespace rayproof::diagnosis
