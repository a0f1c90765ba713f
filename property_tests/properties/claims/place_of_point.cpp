#include "properties/claims/place_of_point.hpp"

#include <algorithm>

#include "properties/claims/promise.hpp"

namespace rayproof {

double excess_of_place(Trial& trial) {
  const auto* claimed = std::get_if<RayAnswer>(&trial.claimed());
  if (claimed == nullptr || !claimed->verdict_only || !claimed->point || claimed->hits.count == 0) return 0;
  const Case& one = trial.question();
  const auto exact = std::get<RayAnswer>(oracle::answer(one));
  const auto line = std::get<RayAnswer>(oracle::answer(on_whole_line(one)));
  if (exact.hits.count == 0 || line.hits.count < 2) return 0;
  const double t = claimed->hits.t[0];
  const auto distance = [t](double hit) { return std::abs(hit - t); };
  const double own = std::ranges::min(line.hits.view(), {}, distance);
  if (own == exact.hits.t[0]) return 0;
  const auto& ray = std::get<RayQuestion>(one.question).ray;
  if (in_interval(ray, own)) {
    RayAnswer at_t = *claimed;
    at_t.verdict_only = false;
    at_t.nearest_only = true;
    const oracle::Judgement as_t = judged(one, at_t);
    const double band = promise_for(trial).verdict;
    return as_t.wrong ? as_t.margin / band : 0;
  }
  // By how much the other hit lies outside the interval, in parts of the scene as the ray sees it.
  constexpr double excused = 0x1p-8;
  const double length = glm::length(ray.direction);
  const double outside = std::max(ray.t_min - own, own - ray.t_max) * length;
  const double scene = glm::length(ray.origin) + std::max(std::abs(own), std::abs(exact.hits.t[0])) * length;
  return scene > 0 ? outside / scene / excused : 0;
}

}  // namespace rayproof
