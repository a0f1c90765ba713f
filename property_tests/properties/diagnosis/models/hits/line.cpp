#include "properties/diagnosis/models/hits/line.hpp"

#include <algorithm>
#include <cmath>

namespace rayproof::diagnosis {
namespace {

/// What `rule(ray, line)` makes of the hits of the whole line; nothing where these are fewer than `least`, or
/// where the case has no ray.
template <class Rule>
Answers from_line(const Case& one, std::size_t least, Rule&& rule) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr) return {};
  const RayAnswer line = hits_of_line(one);
  return line.hits.count < least ? Answers{} : rule(asked->ray, line);
}

/// The same where the ray has a hit.
template <class Rule>
Answers from_line_of_hit(const Case& one, const Answer& exact, std::size_t least, Rule&& rule) {
  const auto* hits = std::get_if<RayAnswer>(&exact);
  return hits == nullptr || hits->hits.count == 0 ? Answers{} : from_line(one, least, rule);
}

double last_of(const RayAnswer& line) { return line.hits.t.at(line.hits.count - 1); }

/// The hit at t alone, if the ray's interval has it.
RayAnswer alone_in_interval(const Ray<double>& ray, const RayAnswer& line, double t) {
  return hits_where(line, [&](double other) { return other == t && in_interval(ray, t); });
}

RayAnswer hit_at_t(double t) {
  RayAnswer answer;
  answer.hits.push_back(t);
  return answer;
}

bool is_cut(const RayAnswer& line, const Ray<double>& ray) {
  return std::ranges::any_of(line.hits.view(), [&](double t) { return !in_interval(ray, t); });
}

/// The ends of what the ray has of the line inside a solid: cut off at t_min, and at t_max or not. An end
/// beyond t_max is then left out.
Answers clipped(const Case& one, const Answer& exact, bool at_t_max) {
  return from_line(one, 2, [&](const Ray<double>& ray, const RayAnswer& line) -> Answers {
    const auto& t = line.hits.t;
    if (line.hits.count != 2 || t[1] < ray.t_min || t[0] > ray.t_max) return {};
    RayAnswer ends = std::get<RayAnswer>(exact);
    ends.hits = {};
    ends.hits.push_back(std::max(t[0], ray.t_min));
    if (t[1] <= ray.t_max || at_t_max) ends.hits.push_back(at_t_max ? std::min(t[1], ray.t_max) : t[1]);
    return {ends};
  });
}

}  // namespace

Answers first_hit_decides(const Case& one, const Answer& exact) {
  return from_line_of_hit(one, exact, 1, [](const Ray<double>& ray, const RayAnswer& line) {
    return in_interval(ray, line.hits.t[0]) ? Answers{} : Answers{RayAnswer{}};
  });
}

Answers last_hit_alone(const Case& one, const Answer& exact) {
  return from_line_of_hit(one, exact, 2, [](const Ray<double>& ray, const RayAnswer& line) {
    return Answers{alone_in_interval(ray, line, last_of(line))};
  });
}

Answers nearer_to_zero_decides(const Case& one, const Answer& exact) {
  return from_line_of_hit(one, exact, 2, [&](const Ray<double>& ray, const RayAnswer& line) {
    const auto& t = line.hits.t;
    const double first = std::get<RayAnswer>(exact).hits.t[0];
    if (std::abs(t[0]) == std::abs(t[1]))  // of two that are as near either may be taken
      return Answers{alone_in_interval(ray, line, t[0]), alone_in_interval(ray, line, t[1])};
    const double nearer = std::abs(t[0]) < std::abs(t[1]) ? t[0] : t[1];
    return first == nearer ? Answers{} : Answers{alone_in_interval(ray, line, nearer)};
  });
}

Answers behind_is_hit(const Case& one, const Answer& exact) {
  return from_line(one, 1, [&](const Ray<double>& ray, const RayAnswer& line) -> Answers {
    // A hit a little before t_min may be rounded to it.
    if (std::get<RayAnswer>(exact).hits.count != 0 || !(last_of(line) <= ray.t_min)) return {};
    if (line.contact != Contact::crossing) return {};  // what is only touched may be missed for itself
    const auto alone = [&](double t) { return hits_where(line, [t](double other) { return other == t; }); };
    return {line, alone(line.hits.t[0]), alone(last_of(line))};
  });
}

Answers near_hit_behind(const Case& one, const Answer& /*exact*/) {
  return from_line(one, 2, [](const Ray<double>& ray, const RayAnswer& line) -> Answers {
    const auto& t = line.hits.t;
    if (!(t[0] < ray.t_min) || !(ray.t_min <= t[1])) return {};
    return {hits_where(line, [&](double hit) { return hit == t[0]; }),
            hits_where(line, [&](double hit) { return hit <= ray.t_max; })};
  });
}

Answers one_hit_admits_all(const Case& one, const Answer& exact) {
  return from_line_of_hit(one, exact, 1, [](const Ray<double>& ray, const RayAnswer& line) {
    return is_cut(line, ray) ? Answers{line} : Answers{};
  });
}

Answers all_hits_or_none(const Case& one, const Answer& exact) {
  return from_line_of_hit(one, exact, 1, [](const Ray<double>& ray, const RayAnswer& line) {
    return is_cut(line, ray) ? Answers{RayAnswer{}} : Answers{};
  });
}

Answers clipped_to_interval(const Case& one, const Answer& exact) { return clipped(one, exact, true); }
Answers clipped_at_t_min(const Case& one, const Answer& exact) { return clipped(one, exact, false); }

Answers behind_at_t_min(const Case& one, const Answer& /*exact*/) {
  return from_line(one, 1, [](const Ray<double>& ray, const RayAnswer& line) -> Answers {
    return last_of(line) < ray.t_min ? Answers{hit_at_t(ray.t_min)} : Answers{};
  });
}

Answers beyond_at_t_max(const Case& one, const Answer& /*exact*/) {
  return from_line(one, 1, [](const Ray<double>& ray, const RayAnswer& line) -> Answers {
    return ray.t_max < line.hits.t[0] ? Answers{hit_at_t(ray.t_max)} : Answers{};
  });
}

Answers far_hit_beyond(const Case& one, const Answer& /*exact*/) {
  return from_line(one, 2, [](const Ray<double>& ray, const RayAnswer& line) -> Answers {
    const auto& t = line.hits.t;
    if (!(t[0] < ray.t_min) || !(ray.t_max < t[1])) return {};
    return {hits_where(line, [&](double hit) { return hit == t[1]; })};
  });
}

Answers far_hit_not_compared(const Case& one, const Answer& /*exact*/) {
  return from_line(one, 2, [](const Ray<double>& ray, const RayAnswer& line) -> Answers {
    const auto& t = line.hits.t;
    if (!(t[0] <= ray.t_max) || !(ray.t_max < t[1])) return {};
    return {hits_where(line, [&](double hit) { return hit >= ray.t_min; })};
  });
}

Answers behind_origin_missed(const Case& one, const Answer& exact) {
  return from_line_of_hit(one, exact, 1, [](const Ray<double>& /*ray*/, const RayAnswer& line) {
    return last_of(line) < 0 ? Answers{RayAnswer{}} : Answers{};
  });
}

Answers inside_decides(const Case& one, const Answer& /*exact*/) {
  return from_line(one, 2, [](const Ray<double>& ray, const RayAnswer& line) -> Answers {
    const auto& t = line.hits.t;
    const double decided = t[0] < 0 && 0 < t[1] ? t[1] : t[0];
    return {hits_where(line, [&](double hit) { return hit == decided && hit <= ray.t_max; })};
  });
}

Answers solid_from_origin(const Case& one, const Answer& /*exact*/) {
  return from_line(one, 2, [](const Ray<double>& ray, const RayAnswer& line) -> Answers {
    const auto& t = line.hits.t;
    if (t[1] < 0) return {RayAnswer{}};
    RayAnswer first;
    first.hits.push_back(std::max(t[0], 0.0));
    if (in_interval(ray, first.hits.t[0])) return {first};
    return t[0] > 0 ? Answers{RayAnswer{}} : Answers{first, RayAnswer{}};
  });
}

}  // namespace rayproof::diagnosis
