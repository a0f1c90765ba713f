#include "oracle/judge/judging.hpp"

#include "oracle/geometry/sizes.hpp"

namespace rayproof::oracle {

std::vector<double> finite_ends(const Ray<double>& ray) {
  std::vector<double> ends;
  for (const double end : {ray.t_min, ray.t_max}) {
    if (std::isfinite(end)) ends.push_back(end);
  }
  return ends;
}

namespace {

/// The size of the inverse of the case's map; 0 without a transform.
double size_of_inverse(const ExactIntersection& exact) {
  const auto& map = exact.ray().map;
  return map ? value(norm(map->row_x, map->row_y, map->row_z) / approximate(exact.ray().scale)) : 0;
}

}  // namespace

Judgement judge(const ExactIntersection& exact, Precision precision, const RayAnswer& claimed) {
  const RayQuestion& question = exact.question();
  const ExactContacts hits = exact.hits();
  Judgement judgement;
  const glm::dmat4 map = question.transform.value_or(glm::dmat4(0));  // zeros have no magnitude to note
  const double inverse = size_of_inverse(exact);
  const auto note = [&](const auto& shape) {
    note_range(judgement, question.ray.origin, question.ray.direction, shape, glm::dvec3(map[0]),
               glm::dvec3(map[1]), glm::dvec3(map[2]), glm::dvec3(map[3]), inverse);
  };
  std::visit(note, question.shape);
  judgement.hit = !hits.empty();
  judgement.wrong = is_wrong_count(hits.size(), claimed);
  if (judgement.wrong || claimed.hits.count > 0) judgement.far = exact.far();
  if (judgement.wrong) {
    const bool may_merge = hits.size() == 2 && claimed.hits.count == 1 && !claimed.nearest_only;
    judgement.margin = in_units(exact.margin(may_merge), precision);
    judgement.ulp = std::nan("");
  }
  if (claimed.verdict_only) return judgement;
  for (std::size_t i = 0; i < claimed.hits.count; ++i) {
    const double t = claimed.hits.t[i];
    const auto ulps_from = [&](const auto& number) { return error_in_ulps(number, t, precision); };
    const double ulps = judgement.wrong ? HUGE_VAL : std::visit(ulps_from, hits[i].t);
    note_error(judgement, precision, t, ulps, [&] { return in_units(exact.residual(t), precision); });
  }
  return judgement;
}

}  // namespace rayproof::oracle
