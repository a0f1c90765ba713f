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
  const ExactContacts hits = exact.hits();
  Judgement judgement;
  // Measures of what overflowed take long: the processor has no quick way with NaN in long doubles.
  if (is_in_vain()) return judgement;
  Magnitudes lengths;
  std::visit([&](const auto& shape) { note_lengths(lengths, exact.question(), shape); },
             exact.question().shape);
  if (exact.ray().map) lengths.note(value(size_of_inverse(exact.ray())));
  lengths.put(judgement);
  judgement.hit = !hits.empty();
  judgement.wrong = is_wrong_count(hits.size(), claimed);
  if (judgement.wrong || claimed.hits.count > 0) judgement.far = exact.far();
  if (judgement.wrong) {
    const bool may_merge = hits.size() == 2 && claimed.hits.count == 1 && !claimed.nearest_only;
    judgement.margin = in_units(exact.margin(may_merge), precision);
    judgement.ulp = std::nan("");
  }
  note_errors(judgement, hits, precision, claimed, [&](double t) { return exact.residual(t); });
  return judgement;
}

}  // namespace rayproof::oracle
