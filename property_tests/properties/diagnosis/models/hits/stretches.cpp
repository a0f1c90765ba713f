#include "properties/diagnosis/models/hits/stretches.hpp"

#include <algorithm>
#include <limits>

#include "properties/claims/answers.hpp"

namespace rayproof::diagnosis {
namespace {

RayAnswer lone_hit(double t) {
  RayAnswer answer;
  answer.hits.push_back(t);
  return answer;
}

/// Whether the case's shape has an inside.
bool is_of_solid(const Case& one) {
  return shape_in<Sphere<double>>(one) != nullptr || shape_in<Box<double>>(one) != nullptr ||
         shape_in<Parallelepiped<double>>(one) != nullptr || shape_in<Cylinder<double>>(one) != nullptr;
}

/// What of a line's hits is not before `start`, and in the interval.
RayAnswer cut_off_at(const Case& one, const HitList& line, double start) {
  const double last = line.t.at(line.count - 1);
  RayAnswer left;
  if (last >= start) left.hits.push_back(std::max(line.t[0], start));
  if (last > left.hits.t[0] && left.hits.count > 0) left.hits.push_back(last);
  return hits_where(left, [&](double t) { return in_interval(ray_question(one)->ray, t); });
}

}  // namespace

Answers cut_off_at_zero(const Case& one, const Answer& /*exact*/) {
  const HitList line = is_of_solid(one) ? hits_of_line(one).hits : HitList{};
  if (line.count == 0 || line.t[0] > 0) return {};
  const double smallest =
      in_precision(one.precision, []<class T>(T) -> double { return std::numeric_limits<T>::min(); });
  return {cut_off_at(one, line, smallest), cut_off_at(one, line, 0)};
}

Answers exit_at_t_max(const Case& one, const Answer& /*exact*/) {
  const HitList line = is_of_solid(one) ? hits_of_line(one).hits : HitList{};
  if (line.count < 2) return {};
  const Ray<double>& ray = ray_question(one)->ray;
  if (!(line.t[0] <= ray.t_max && ray.t_max < line.t[1])) return {};
  RayAnswer clipped;
  for (const double t : {line.t[0], ray.t_max})
    if (in_interval(ray, t)) clipped.hits.push_back(t);
  return {clipped};
}

Answers zero_from_inside(const Case& one, const Answer& /*exact*/) {
  const HitList line = is_of_solid(one) ? hits_of_line(one).hits : HitList{};
  if (line.count < 2 || !(line.t[0] < 0 && 0 < line.t[1])) return {};
  return in_interval(ray_question(one)->ray, 0.0) ? Answers{lone_hit(0)} : Answers{};
}

std::optional<bool> is_at_minus_one(const Case& /*one*/, const Answer& got, const Answer& exact) {
  const auto* hits = std::get_if<RayAnswer>(&got);
  if (hits == nullptr || hits->verdict_only || numbers_in(exact) == std::vector{-1.0}) return std::nullopt;
  return numbers_in(got) == std::vector{-1.0};
}

std::optional<bool> misses_at_minus_one(const Case& one, const Answer& got, const Answer& exact) {
  return finds_something(exact) ? std::nullopt : is_at_minus_one(one, got, exact);
}

}  // namespace rayproof::diagnosis
