#include "oracle/shapes/quadric.hpp"

#include <algorithm>

#include "oracle/geometry/intersection.hpp"
#include "oracle/numbers/ulp.hpp"

namespace rayproof::oracle {
namespace {

using Four = std::array<Ring, 4>;

Four four(double x, double y, double z, double w) { return {Ring(x), Ring(y), Ring(z), Ring(w)}; }

/// The polar form of twice the quadric: 2·f(p) for q = p, both homogeneous.
Ring polar(const implicit::Quadric<double>& f, const Four& p, const Four& q) {
  const auto term = [&](double coefficient, std::size_t i, std::size_t j) {
    return Ring(coefficient) * (p[i] * q[j] + p[j] * q[i]);
  };
  return term(f.xx, 0, 0) + term(f.yy, 1, 1) + term(f.zz, 2, 2) + term(f.ww, 3, 3) + term(f.xy, 0, 1) +
         term(f.xz, 0, 2) + term(f.yz, 1, 2) + term(f.xw, 0, 3) + term(f.yw, 1, 3) + term(f.zw, 2, 3);
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
  const Four o = four(ray.origin.x, ray.origin.y, ray.origin.z, 1);
  const Four d = four(ray.direction.x, ray.direction.y, ray.direction.z, 0);
  return solve(polar(quadric, d, d), polar(quadric, o, d), polar(quadric, o, o));
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
