#include "properties/diagnosis/models/hits/wrong_interval.hpp"

#include "properties/claims/answers.hpp"

namespace rayproof::diagnosis {
namespace {

/// The line's hits from t_min to t_max.
RayAnswer within(const Case& one, double t_min, double t_max) {
  return hits_where(hits_of_line(one), [&](double t) { return t_min <= t && t <= t_max; });
}

}  // namespace

Answers farther_of_both(const Case& one, const Answer& /*exact*/) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr) return {};
  const RayAnswer line = hits_of_line(one);
  const auto& t = line.hits.t;
  if (line.hits.count != 2) return {};
  const bool are_both_in = in_interval(asked->ray, t[0]) && in_interval(asked->ray, t[1]);
  return {hits_where(line, [&](double other) { return are_both_in && other == t[1]; })};
}

Answers beyond_both_ends(const Case& one, const Answer& /*exact*/) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr) return {};
  const double last = std::max(asked->ray.t_min, asked->ray.t_max);
  return {hits_where(hits_of_line(one), [&](double t) { return t > last; })};
}

bool has_hit_beyond_both(const Case& one, const Answer& exact) {
  return std::ranges::any_of(beyond_both_ends(one, exact), finds_something);
}

Answers smaller_without_sign(const Case& one, const Answer& /*exact*/) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr) return {};
  const HitList hits = hits_of_line(one).hits;
  if (hits.count != 2 || hits.t[1] < 0) return {};
  RayAnswer smaller;
  smaller.hits.push_back(std::min(std::abs(hits.t[0]), hits.t[1]));
  return {hits_where(smaller, [&](double t) { return in_interval(asked->ray, t); })};
}

Answers absolute_t_min(const Case& one, const Answer& /*exact*/) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr || !(asked->ray.t_min < 0)) return {};
  return {within(one, -asked->ray.t_min, asked->ray.t_max)};
}

Answers infinity_as_zero(const Case& one, const Answer& /*exact*/) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr) return {};
  const auto or_zero = [](double end) { return std::isinf(end) ? 0.0 : end; };
  const auto& [t_min, t_max] = std::pair(asked->ray.t_min, asked->ray.t_max);
  if (or_zero(t_min) == t_min && or_zero(t_max) == t_max) return {};
  return {within(one, t_min, or_zero(t_max)), within(one, or_zero(t_min), or_zero(t_max))};
}

std::vector<Case> t_max_as_length(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    asked.ray.t_max -= asked.ray.t_min;
    return asked.ray.t_min != 0;
  });
}

Answers begins_at(const Case& one, double t_min) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr) return {};
  return {hits_where(hits_of_line(one), [&](double t) { return t_min < t && t <= asked->ray.t_max; })};
}

Answers cut_at(const Case& one, double end) {
  const bool has_slabs =
      shape_in<Box<double>>(one) != nullptr || shape_in<Parallelepiped<double>>(one) != nullptr;
  const HitList line = has_slabs ? hits_of_line(one).hits : HitList();
  if (line.count == 0) return {};
  const double entry = line.t[0], exit = line.t[line.count - 1];
  if (-end <= entry && exit <= end) return {};
  RayAnswer cut;
  if (entry <= end && exit >= -end) {
    cut.hits.push_back(std::max(entry, -end));
    cut.hits.push_back(std::min(exit, end));
  }
  return {hits_where(cut, [&](double t) { return in_interval(ray_question(one)->ray, t); })};
}

Answers offset_by(const Answer& exact, double length) {
  const auto* given = std::get_if<RayAnswer>(&exact);
  if (given == nullptr || given->hits.count == 0) return {};
  Answers answers;
  for (const double by : {-length, length}) {
    RayAnswer moved = *given;
    for (double& t : moved.hits.t) t += by;
    answers.emplace_back(moved);
  }
  return answers;
}

}  // namespace rayproof::diagnosis
