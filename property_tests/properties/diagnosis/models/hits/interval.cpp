#include "properties/diagnosis/models/hits/interval.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "properties/boundary.hpp"
#include "properties/claims/answers.hpp"
#include "properties/diagnosis/examination/agreement.hpp"
#include "properties/edges.hpp"

namespace rayproof::diagnosis {
namespace {

std::vector<Case> with_interval(const Case& one, double t_min, double t_max) {
  return with_question(one, [&](RayQuestion& asked) {
    asked.ray.t_min = t_min;
    asked.ray.t_max = t_max;
    return true;
  });
}

const Ray<double>* ray_of(const Case& one) {
  const RayQuestion* asked = ray_question(one);
  return asked == nullptr ? nullptr : &asked->ray;
}

/// The hits that are left where `is_dropped(ray, t)` drops some; nothing where it drops none.
template <class Dropped>
Answers without_hits(const Case& one, const Answer& exact, Dropped&& is_dropped) {
  const Ray<double>* ray = ray_of(one);
  if (ray == nullptr) return {};
  const auto& all = std::get<RayAnswer>(exact);
  const RayAnswer left = hits_where(all, [&](double t) { return !is_dropped(*ray, t); });
  return left.hits.count == all.hits.count ? Answers{} : Answers{left};
}

/// The same at the interval's ends, unless rounding decides whether t is an end, or whether the rim of a
/// capped cylinder is met there.
template <class AtEnd>
Answers open_where(const Case& one, const Answer& exact, AtEnd&& is_at_end) {
  const Answers open = without_hits(one, exact, is_at_end);
  if (open.empty() || !is_exact_for_some_method(one)) return {};
  const bool is_rim = std::ranges::any_of(std::get<RayAnswer>(exact).hits.view(), [&](double t) {
    return is_at_end(*ray_of(one), t) && is_at_rim(one, t, share_of_rounding(one.precision));
  });
  return is_rim ? Answers{} : open;
}

}  // namespace

std::vector<Case> without_t_max(const Case& one) {
  const auto* ray = ray_of(one);
  return ray == nullptr ? std::vector<Case>{} : with_interval(one, ray->t_min, infinity<double>);
}

std::vector<Case> without_t_min(const Case& one) {
  const auto* ray = ray_of(one);
  return ray == nullptr ? std::vector<Case>{} : with_interval(one, -infinity<double>, ray->t_max);
}

std::vector<Case> without_interval(const Case& one) {
  return with_interval(one, -infinity<double>, infinity<double>);
}

Answers t_min_is_zero(const Case& one, const Answer& /*exact*/) {
  const auto* ray = ray_of(one);
  if (ray == nullptr) return {};
  if (ray->t_max < 0) return {RayAnswer{}};
  return exact_of(with_interval(one, 0, ray->t_max));
}

Answers t_min_cut_to_zero(const Case& one, const Answer& exact) {
  const auto* ray = ray_of(one);
  return ray == nullptr || ray->t_min >= 0 ? Answers{} : t_min_is_zero(one, exact);
}

Answers t_min_as_t_max(const Case& one, const Answer& /*exact*/) {
  const auto* ray = ray_of(one);
  if (ray == nullptr || ray->t_min == infinity<double>) return {};
  return {hits_where(hits_of_line(one), [&](double t) { return 0 <= t && t <= ray->t_min; })};
}

bool has_hit_before_t_min(const Case& one, const Answer& exact) {
  return std::ranges::any_of(t_min_as_t_max(one, exact), finds_something);
}

Answers t_squared_to_t_max(const Case& one, const Answer& /*exact*/) {
  const auto* ray = ray_of(one);
  if (ray == nullptr) return {};
  const RayAnswer line = hits_of_line(one);
  Answers answers;
  for (const double square_of_unit : {1.0, glm::dot(ray->direction, ray->direction)})
    for (const double most : {infinity<double>, ray->t_max})
      answers.emplace_back(hits_where(line, [&](double t) {
        return ray->t_min <= t && t <= most && t * t * square_of_unit <= ray->t_max;
      }));
  return answers;
}

Answers zero_as_no_end(const Case& one, const Answer& /*exact*/) {
  const auto* ray = ray_of(one);
  if (ray == nullptr || ray->t_max != 0) return {};
  return exact_of(without_t_max(one));
}

std::vector<Case> from_origin_on(const Case& one) { return with_interval(one, 0, infinity<double>); }

std::vector<Case> as_segment(const Case& one) { return with_interval(one, 0, 1); }

std::vector<Case> interval_as_distances(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    const double length = glm::length(asked.ray.direction);
    asked.ray.t_min /= length;
    asked.ray.t_max /= length;
    return length != 1;
  });
}

std::vector<Case> t_max_as_distance(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    const double length = glm::length(asked.ray.direction);
    asked.ray.t_max /= length;
    return length != 1;
  });
}

std::vector<Case> interval_as_object_distances(const Case& one) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr) return {};
  const double length = glm::length(ray_in_object(*asked).direction);
  return with_interval(one, asked->ray.t_min / length, asked->ray.t_max / length);
}

std::vector<Case> t_max_as_object_distance(const Case& one) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr) return {};
  return with_interval(one, asked->ray.t_min,
                       asked->ray.t_max / glm::length(ray_in_object(*asked).direction));
}

Answers t_from_t_min(const Case& one, const Answer& exact) {
  const Ray<double>* ray = ray_of(one);
  if (ray == nullptr || ray->t_min == 0 || !finds_something(exact)) return {};
  auto counted = std::get<RayAnswer>(exact);
  for (double& t : counted.hits.t) t -= ray->t_min;
  return {std::isfinite(ray->t_min) ? counted : RayAnswer{}};
}

Answers drops(const Case& one, const Answer& exact, bool (*is_dropped)(double t)) {
  return without_hits(one, exact,
                      [is_dropped](const Ray<double>& /*ray*/, double t) { return is_dropped(t); });
}

Answers drops_below_epsilon(const Case& one, const Answer& exact) {
  return in_precision(one.precision, [&]<class T>(T) -> Answers {
    constexpr double epsilon = std::numeric_limits<T>::epsilon();
    const Answers by_t = drops(one, exact, [](double t) { return t <= epsilon; });
    const Answers by_distance = without_hits(one, exact, [](const Ray<double>& ray, double t) {
      return t * glm::length(ray.direction) <= epsilon;
    });
    if (by_t.empty() && by_distance.empty()) return {};
    return {by_t.empty() ? exact : by_t.front(), by_distance.empty() ? exact : by_distance.front()};
  });
}

bool has_first_hit_before_origin(const Case& one, const Answer& exact) {
  const auto* hits = std::get_if<RayAnswer>(&exact);
  return hits != nullptr && hits->hits.count > 0 && hits->hits.t[0] > 0 &&
         hits->hits.t[0] != ray_of(one)->t_min;
}

bool has_first_hit_behind_origin(const Case& /*one*/, const Answer& exact) {
  const auto* hits = std::get_if<RayAnswer>(&exact);
  return hits != nullptr && hits->hits.count > 0 && hits->hits.t[0] < 0;
}

Answers open_at_t_min(const Case& one, const Answer& exact) {
  return open_where(one, exact, [](const Ray<double>& ray, double t) { return t == ray.t_min; });
}

Answers open_at_t_max(const Case& one, const Answer& exact) {
  return open_where(one, exact, [](const Ray<double>& ray, double t) { return t == ray.t_max; });
}

Answers open_at_both_ends(const Case& one, const Answer& exact) {
  return open_where(one, exact,
                    [](const Ray<double>& ray, double t) { return t == ray.t_min || t == ray.t_max; });
}

Answers open_at_zero(const Case& one, const Answer& exact) {
  return open_where(one, exact, [](const Ray<double>& /*ray*/, double t) { return t == 0; });
}

Answers open_where_entering(const Case& one, const Answer& exact) {
  const auto* hits = std::get_if<RayAnswer>(&exact);
  return hits != nullptr && enters_at_origin(*hits) ? open_at_zero(one, exact) : Answers{};
}

Answers open_where_leaving(const Case& one, const Answer& exact) {
  const auto* hits = std::get_if<RayAnswer>(&exact);
  const RayQuestion* asked = ray_question(one);
  if (hits == nullptr || asked == nullptr || !leaves_at_origin(*asked, *hits)) return {};
  Answers missed = open_at_zero(one, exact);
  // Of a ray that only touches an edge or a corner there the entry may count.
  if (!missed.empty() && hits->contact != Contact::crossing) missed.push_back(exact);
  return missed;
}

std::optional<bool> hits_before_t_min(const Case& one, const Answer& got, const Answer& /*exact*/) {
  const Ray<double>* ray = ray_of(one);
  if (ray == nullptr) return std::nullopt;
  const double scale = size_of_scene(one) / glm::length(ray->direction);
  const auto has_one = [&](const RayAnswer& answer) {
    return std::ranges::any_of(answer.hits.view(), [&](double t) {
      return t < ray->t_min && !are_close(one.precision, t, ray->t_min, scale);
    });
  };
  if (has_one(std::get<RayAnswer>(got))) return true;
  return has_one(hits_of_line(one)) ? std::optional(false) : std::nullopt;
}

}  // namespace rayproof::diagnosis
