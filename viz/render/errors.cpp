#include "viz/render/errors.hpp"

#include <algorithm>
#include <cmath>

#include "oracle/numbers/ulp.hpp"
#include "viz/render/hits.hpp"

namespace rayproof::render {
namespace {

Totals count(const ErrorImage& errors, const HitImage& exact) {
  const auto count_of = [&](Verdict verdict) {
    return static_cast<std::size_t>(std::ranges::count(errors.verdicts, verdict));
  };
  Totals totals{.pixels = errors.verdicts.size(),
                .wrong_hits = count_of(Verdict::wrong_hit),
                .wrong_misses = count_of(Verdict::wrong_miss),
                .wrong_objects = count_of(Verdict::wrong_object),
                .hits = count_of(Verdict::hit)};
  for (std::size_t i = 0; i < errors.verdicts.size(); ++i) {
    if (exact.object[i] != no_object) ++totals.exact_hits;
    if (errors.verdicts[i] == Verdict::hit) ++totals.steps[step_of(errors.ulps[i])];
    totals.worst_ulps = std::max(totals.worst_ulps, errors.ulps[i]);
  }
  return totals;
}

}  // namespace

std::size_t step_of(double ulps) {
  std::size_t step = 0;
  while (step + 1 < ulp_steps.size() && ulps >= ulp_steps[step + 1].from) ++step;
  return step;
}

ErrorImage find_errors(const RenderScene& scene, const HitImage& exact, const HitImage& claimed,
                       const Work& work) {
  ErrorImage errors{exact.width, exact.height, std::vector<Verdict>(exact.t.size()),
                    std::vector<double>(exact.t.size())};
  const auto judge = [&](int x, int y) {
    const std::size_t i = exact.index(x, y);
    const ObjectIndex truth = exact.object[i], claim = claimed.object[i];
    if (truth == no_object) return claim == no_object ? Verdict::miss : Verdict::wrong_hit;
    if (claim == no_object) return Verdict::wrong_miss;
    if (claim == truth) return Verdict::hit;
    // Another object than the exact one, met at the same rounded t, is as good an answer.
    const ExactHit hit = exact_hit(scene, claim, pixel_ray(scene, x, y));
    return hit.is_hit && hit.t == exact.t[i] ? Verdict::hit : Verdict::wrong_object;
  };
  for_each_pixel(exact.width, exact.height, work, [&](int x, int y) {
    const std::size_t i = exact.index(x, y);
    errors.verdicts[i] = judge(x, y);
    if (errors.verdicts[i] == Verdict::hit)
      errors.ulps[i] = oracle::error_in_ulps(exact.t[i], claimed.t[i], scene.precision);
  });
  errors.totals = count(errors, exact);
  return errors;
}

}  // namespace rayproof::render
