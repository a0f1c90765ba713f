#include "oracle/judge/judging.hpp"

namespace rayproof::oracle {

std::vector<double> finite_ends(const Ray<double>& ray) {
  std::vector<double> ends;
  for (const double end : {ray.t_min, ray.t_max}) {
    if (std::isfinite(end)) ends.push_back(end);
  }
  return ends;
}

Judgement judge(const ExactIntersection& exact, Precision precision, const RayAnswer& claimed) {
  const RayQuestion& question = exact.question();
  const ExactContacts hits = exact.hits();
  Judgement judgement;
  const glm::dmat4 map = question.transform.value_or(glm::dmat4(0));  // zeros have no magnitude to note
  const auto note = [&](const auto& shape) {
    note_range(judgement, question.ray.origin, question.ray.direction, shape, glm::dvec3(map[0]),
               glm::dvec3(map[1]), glm::dvec3(map[2]), glm::dvec3(map[3]));
  };
  std::visit(note, question.shape);
  if (const auto& inverse = exact.ray().map) {
    const Scaled determinant = approximate(exact.ray().scale);
    for (const Vector<Ring>* row : {&inverse->row_x, &inverse->row_y, &inverse->row_z})
      note_range(judgement, value(approximate(row->x) / determinant),
                 value(approximate(row->y) / determinant), value(approximate(row->z) / determinant));
  }
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
