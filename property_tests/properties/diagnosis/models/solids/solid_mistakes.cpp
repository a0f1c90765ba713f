#include "properties/diagnosis/models/solids/solid_mistakes.hpp"

#include <algorithm>
#include <cmath>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/solids/slabs.hpp"

namespace rayproof::diagnosis {
namespace {

/// The span of t in which the line is inside; empty where first > last.
struct Span {
  double first = -infinity<double>, last = infinity<double>;
};

/// Takes in a slab by "if the beginning is later, else if the end is earlier", or the other way round.
void cut_in_else(Span& span, double near, double far, bool ends_first) {
  const bool is_later = near > span.first, is_earlier = far < span.last;
  if (is_later && !(ends_first && is_earlier)) span.first = near;
  if (is_earlier && (ends_first || !is_later)) span.last = far;
}

}  // namespace

Answers exit_beyond_end_missed(const Case& one, const Answer& exact) {
  if (!cube_in(one) || !finds_something(exact)) return {};
  const RayAnswer line = hits_of_line(one);
  const double last = line.hits.t.at(line.hits.count - 1);
  return last > ray_question(one)->ray.t_max ? Answers{RayAnswer{}} : Answers{};
}

Answers slab_ends_in_else(const Case& one, const Answer& /*exact*/) {
  const auto cube = cube_in(one);
  if (!cube) return {};
  const auto slabs = slabs_of(*cube);
  if (!slabs) return {RayAnswer{}};
  Answers answers;
  for (const bool ends_first : {false, true}) {
    Span span;
    for (std::size_t i = 0; i < slabs->enters.size(); ++i)
      cut_in_else(span, slabs->enters[i], slabs->leaves[i], ends_first);
    const Answers found = inside_from(one, span.first, span.last);
    answers.push_back(found.front());
    // What is infinite may be left out.
    answers.emplace_back(
        hits_where(std::get<RayAnswer>(found.front()), [](double t) { return std::isfinite(t); }));
  }
  return answers;
}

Answers sum_of_coordinates_tested(const Case& one, const Answer& /*exact*/) {
  const auto cube = shape_in<Parallelepiped<double>>(one) == nullptr ? std::nullopt : cube_in(one);
  if (!cube) return {};
  const auto slabs = slabs_of(*cube);
  const auto& [o, d, t_min, t_max] = cube->ray;
  const double sum = o.x + o.y + o.z, slope = d.x + d.y + d.z;
  if (!slabs || (slope == 0 && sum > 1)) return {RayAnswer{}};
  Span span{std::ranges::max(slabs->enters), std::ranges::min(slabs->leaves)};
  if (slope > 0) span.last = std::min(span.last, (1 - sum) / slope);
  if (slope < 0) span.first = std::max(span.first, (1 - sum) / slope);
  return inside_from(one, span.first, span.last);
}

Answers one_by_transposed(const Case& one, const Answer& /*exact*/) {
  const auto* solid = shape_in<Parallelepiped<double>>(one);
  const auto cube = cube_in(one);
  if (solid == nullptr || !cube) return {};
  const glm::dmat3 to_frame =
      glm::transpose(glm::inverse(glm::dmat3(solid->edges[0], solid->edges[1], solid->edges[2])));
  const Ray<double> ray = ray_in_object(*ray_question(one));
  Cube by_direction = *cube, by_origin = *cube;
  by_direction.ray.direction = to_frame * ray.direction;
  by_origin.ray.origin = to_frame * (ray.origin - solid->corner);
  return {through_slabs(one, by_direction).front(), through_slabs(one, by_origin).front()};
}

}  // namespace rayproof::diagnosis
