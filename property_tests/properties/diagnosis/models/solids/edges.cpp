#include "properties/diagnosis/models/solids/edges.hpp"

#include <algorithm>
#include <cmath>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/solids/apart.hpp"
#include "properties/diagnosis/models/solids/rounded_box.hpp"
#include "properties/edges.hpp"

namespace rayproof::diagnosis {
namespace {

/// Whether the line passes the inside of the solid, and does not only touch it or run in a face.
bool goes_on_inside(const Case& one) {
  const HitList line = hits_of_line(one).hits;
  if (line.count < 2) return false;
  const auto cube = cube_in(one);
  if (!cube) return true;
  const glm::dvec3 size = cube->high - cube->low;
  const glm::dvec3 share = (point_at(cube->ray, (line.t[0] + line.t[1]) / 2) - cube->low) / size;
  const auto is_inside = [](double x) { return 0x1p-20 < x && x < 1 - 0x1p-20; };
  return is_inside(share.x) && is_inside(share.y) && is_inside(share.z);
}

}  // namespace

std::optional<bool> missed_through_edge(const Case& one, const Answer& got, const Answer& exact) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr || finds_something(got) || !finds_something(exact)) return std::nullopt;
  const double t = std::get<RayAnswer>(exact).hits.t[0];
  constexpr double from_afar = 32;  // times as much rounding, where what leads to the hit cancels
  return is_at_edge(one, t, from_afar * share_of_rounding(one.precision)) && goes_on_inside(one);
}

std::optional<bool> has_rounded_edges(const Case& one, const Answer& got, const Answer& exact) {
  const double margin = thickness_of(one) / 8;
  const std::optional<Apart> core = Apart::from(one, margin), solid = Apart::from(one, 0);
  if (!core || shape_in<Sphere<double>>(one) != nullptr || !finds_something(exact)) return std::nullopt;
  if (std::get<RayAnswer>(got).verdict_only || is_of_rounded_centre(one, got, exact)) return std::nullopt;
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const HitList &hits = std::get<RayAnswer>(exact).hits, &found = std::get<RayAnswer>(got).hits;
  if (found.count == 0) {
    const double last = hits.t.at(hits.count - 1);
    return core->least(ray, std::max(hits.count > 1 ? hits.t[0] : ray.t_min, ray.t_min), last) > margin;
  }
  const double t = found.t[0], near = share_of_rounding(one.precision) * size_of_scene(one);
  if (std::abs(t - hits.t[0]) * glm::length(ray.direction) <= near) return std::nullopt;
  const glm::dvec3 place = point_at(ray, t);
  return t > hits.t[0] && solid->at(place) <= near && core->at(place) >= margin;
}

std::optional<bool> stops_before(const Case& one, const Answer& got, const Answer& exact, double length) {
  const std::optional<Apart> solid = Apart::from(one, 0);
  const auto& [ours, right] = std::pair(std::get_if<RayAnswer>(&got), std::get_if<RayAnswer>(&exact));
  if (!solid || ours == nullptr || ours->verdict_only || ours->hits.count == 0) return std::nullopt;
  const double t = ours->hits.t[0], near = share_of_rounding(one.precision) * size_of_scene(one);
  if (!std::isfinite(t)) return false;
  const Ray<double> ray = ray_in_object(*ray_question(one));
  const bool is_hit = right->hits.count > 0;
  const double apart = solid->at(point_at(ray, t)), early = near / 8;  // what is early is so by no rounding
  // Behind the surface another fault shows.
  if (is_hit && (t - right->hits.t[0]) * glm::length(ray.direction) >= -early) return std::nullopt;
  return early < apart && apart <= length;
}

}  // namespace rayproof::diagnosis
