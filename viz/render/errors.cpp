#include "viz/render/errors.hpp"

#include <algorithm>
#include <cmath>

#include "oracle/numbers/ulp.hpp"
#include "viz/render/hits.hpp"

namespace rayproof::render {
namespace {

/// Whether another object than the exact one is met at the same rounded t: as good an answer.
bool is_as_near(const RenderScene& scene, ObjectIndex object, double t, int x, int y) {
  const ExactHit hit = exact_hit(scene, object, pixel_ray(scene, x, y));
  return hit.is_hit && hit.t == t;
}

Totals count(const ErrorImage& errors, const HitImage& exact) {
  Totals totals;
  totals.pixels = errors.verdicts.size();
  for (std::size_t i = 0; i < errors.verdicts.size(); ++i) {
    if (exact.object[i] != no_object) ++totals.exact_hits;
    switch (errors.verdicts[i]) {
      case Verdict::miss:
        break;
      case Verdict::hit:
        ++totals.hits;
        ++totals.steps[step_of(errors.ulps[i])];
        totals.worst_ulps = std::max(totals.worst_ulps, errors.ulps[i]);
        break;
      case Verdict::wrong_hit:
        ++totals.wrong_hits;
        break;
      case Verdict::wrong_miss:
        ++totals.wrong_misses;
        break;
      case Verdict::wrong_object:
        ++totals.wrong_objects;
    }
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
  ErrorImage errors{exact.width,
                    exact.height,
                    std::vector<Verdict>(exact.t.size(), Verdict::miss),
                    std::vector<double>(exact.t.size(), 0.0),
                    {}};
  const auto judge = [&](int x, int y) {
    const std::size_t i = exact.index(x, y);
    const ObjectIndex truth = exact.object[i], claim = claimed.object[i];
    if (truth == no_object) return claim == no_object ? Verdict::miss : Verdict::wrong_hit;
    if (claim == no_object) return Verdict::wrong_miss;
    const bool is_right = claim == truth || is_as_near(scene, claim, exact.t[i], x, y);
    return is_right ? Verdict::hit : Verdict::wrong_object;
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
