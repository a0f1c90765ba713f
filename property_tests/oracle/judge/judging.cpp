#include "oracle/judge/judging.hpp"

#include <algorithm>

#include "case/each_number.hpp"

namespace rayproof::oracle {
namespace {

/// Every number that the domain of a contract speaks of.
std::vector<double> numbers_of(const RayQuestion& question) {
  std::vector<double> all;
  const auto gather = [&](const auto& value) { each_number(value, [&](double x) { all.push_back(x); }); };
  gather(question.ray.origin);
  gather(question.ray.direction);
  std::visit(gather, question.shape);
  if (question.transform) {
    for (int column = 0; column < 4; ++column) gather(glm::dvec3((*question.transform)[column]));
  }
  return all;
}

}  // namespace

RaySizes::RaySizes(const RayQuestion& question, const ObjectRay<Ring>& ray)
    : origin(norm(question.ray.origin)), direction(norm(question.ray.direction)) {
  if (!ray.map) return;
  const MapSizes<Ring> map(*question.transform, *ray.map);
  const Scaled backward = map.backward / abs(approximate(ray.scale));
  const Scaled growth = backward * map.forward * backward;
  origin = growth * (origin + norm(ray.map->translation));
  direction = growth * direction;
}

std::vector<double> finite_ends(const Ray<double>& ray) {
  std::vector<double> ends;
  for (const double end : {ray.t_min, ray.t_max}) {
    if (std::isfinite(end)) ends.push_back(end);
  }
  return ends;
}

void note_range(std::span<const double> numbers, Judgement& judgement) {
  judgement.smallest = HUGE_VAL;
  judgement.largest = -HUGE_VAL;
  for (const double x : numbers) {
    if (x == 0) continue;
    judgement.smallest = std::min(judgement.smallest, std::logb(x));
    judgement.largest = std::max(judgement.largest, std::logb(x));
  }
}

Judgement judge_hits(const RayQuestion& question, const Figure& figure, Precision precision,
                     const RayAnswer& claimed) {
  const std::vector<ExactNumber> exact = figure.hits();
  const Scaled epsilon(unit_roundoff(precision));
  const auto in_units = [&](const Scaled& error) { return static_cast<double>((error / epsilon).value()); };
  Judgement judgement;
  note_range(numbers_of(question), judgement);
  judgement.far = figure.far();
  judgement.hit = !exact.empty();
  const std::size_t expected = claimed.nearest_only ? std::min<std::size_t>(exact.size(), 1) : exact.size();
  judgement.wrong = expected != claimed.hits.count;
  if (judgement.wrong) {
    judgement.margin = in_units(figure.margin());
    judgement.ulp = std::nan("");
  }
  for (std::size_t i = 0; i < claimed.hits.count; ++i) {
    const double t = claimed.hits.t[i];
    const auto ulps_from = [&](const auto& number) { return error_in_ulps(number, t, precision); };
    const double ulps = judgement.wrong ? HUGE_VAL : std::visit(ulps_from, exact[i]);
    if (!judgement.wrong) judgement.ulp = std::max(judgement.ulp, ulps);
    if (is_best_on_grid(t, ulps, precision)) continue;
    judgement.residual =
        std::max(judgement.residual, std::isfinite(t) ? in_units(figure.residual(t)) : HUGE_VAL);
  }
  return judgement;
}

}  // namespace rayproof::oracle
