#include "oracle/shapes/quadric.hpp"

#include <algorithm>

#include "oracle/geometry/intersection.hpp"
#include "oracle/numbers/ulp.hpp"

namespace rayproof::oracle {
namespace {

using Four = std::array<Ring, 4>;

Four four(double x, double y, double z, double w) { return {Ring(x), Ring(y), Ring(z), Ring(w)}; }

/// The quadric as the symmetric matrix M with pᵀMp = 2·f(p), p homogeneous.
std::array<Four, 4> matrix_of(const implicit::Quadric<double>& q) {
  std::array<Four, 4> m{four(q.xx, q.xy, q.xz, q.xw), four(q.xy, q.yy, q.yz, q.yw),
                        four(q.xz, q.yz, q.zz, q.zw), four(q.xw, q.yw, q.zw, q.ww)};
  for (std::size_t i = 0; i < 4; ++i) m[i][i] = m[i][i] + m[i][i];
  return m;
}

/// pᵀMq.
Ring between(const Four& p, const std::array<Four, 4>& m, const Four& q) {
  Ring sum(0.0);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) sum = sum + p[i] * m[i][j] * q[j];
  return sum;
}

RootList roots_between(const RootList& roots, double low, double high) {
  RootList inside;
  for (const ExactRoot& root : roots)
    if (is_in_interval(root, low, high)) inside.push_back(root);
  return inside;
}

void judge_certain(const RootEnclosure<double>& one, const RootList& inside, RootKind kind,
                   Precision precision, EnclosureJudgement& judgement) {
  if (inside.size() != 1 || kind == RootKind::twice) {
    judgement.is_wrong_certain = true;
    return;
  }
  ++judgement.certain;
  const double ulp = ulp_of(round_correctly(inside.front(), precision), precision);
  const double width = one.lo == one.hi ? 0 : (one.hi - one.lo) / ulp;
  if (width <= 64) ++judgement.narrow;
  judgement.widest = std::max(judgement.widest, width);
}

}  // namespace

SolvedEquation meet(const Ray<double>& ray, const implicit::Quadric<double>& quadric) {
  const std::array<Four, 4> m = matrix_of(quadric);
  const Four o = four(ray.origin.x, ray.origin.y, ray.origin.z, 1);
  const Four d = four(ray.direction.x, ray.direction.y, ray.direction.z, 0);
  return solve(between(d, m, d), between(o, m, d), between(o, m, o));
}

EnclosureJudgement judge(const Ray<double>& ray, const implicit::Quadric<double>& quadric,
                         Precision precision, const EnclosedRoots<double>& claimed) {
  const auto [kind, roots] = meet(ray, quadric);
  const bool is_everything = kind == RootKind::everything;
  const RootList hits = roots_between(roots, ray.t_min, ray.t_max);
  EnclosureJudgement judgement;
  judgement.known = hits.size();
  if (kind == RootKind::twice) judgement.tangents = hits.size();
  for (const ExactRoot& root : hits) {
    const auto holds = [&](const auto& one) { return is_in_interval(root, one.lo, one.hi); };
    judgement.has_missed = judgement.has_missed || std::none_of(claimed.begin(), claimed.end(), holds);
  }
  double reached = ray.t_min;
  bool has_gap = claimed.empty();
  for (const RootEnclosure<double>& one : claimed) {
    if (!(reached <= one.lo && one.lo <= one.hi && one.hi <= ray.t_max)) judgement.is_ordered = false;
    has_gap = has_gap || one.lo > reached;
    reached = one.hi;
    const RootList inside = roots_between(hits, one.lo, one.hi);
    if (one.status == RootStatus::certain) {
      judge_certain(one, inside, kind, precision, judgement);
    } else if (one.status == RootStatus::everywhere) {
      judgement.is_wrong_everywhere = judgement.is_wrong_everywhere || !is_everything;
    } else if (inside.empty() && !is_everything) {
      ++judgement.idle;
    }
  }
  has_gap = has_gap || reached < ray.t_max;
  judgement.has_missed = judgement.has_missed || (is_everything && has_gap);
  return judgement;
}

}  // namespace rayproof::oracle
