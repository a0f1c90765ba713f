#include "oracle/shapes/quadric.hpp"

#include <algorithm>

#include "oracle/geometry/intersection.hpp"
#include "oracle/numbers/rounding.hpp"

namespace rayproof::oracle {
namespace {

using Four = std::array<Ring, 4>;

/// The quadric as the symmetric matrix M with pᵀMp = 2·f(p), p homogeneous.
class Matrix {
 public:
  explicit Matrix(const implicit::Quadric<double>& q) {
    const std::array<double, 4> diagonal{q.xx, q.yy, q.zz, q.ww};
    for (std::size_t i = 0; i < 4; ++i) m_[i][i] = Ring(diagonal[i]) + Ring(diagonal[i]);
    m_[1][2] = m_[2][1] = Ring(q.yz);
    m_[0][2] = m_[2][0] = Ring(q.xz);
    m_[0][1] = m_[1][0] = Ring(q.xy);
    m_[0][3] = m_[3][0] = Ring(q.xw);
    m_[1][3] = m_[3][1] = Ring(q.yw);
    m_[2][3] = m_[3][2] = Ring(q.zw);
  }

  /// pᵀMq.
  [[nodiscard]] Ring between(const Four& p, const Four& q) const {
    Ring sum(0.0);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) sum = sum + p[i] * m_[i][j] * q[j];
    return sum;
  }

 private:
  std::array<Four, 4> m_;
};

Four homogeneous(const glm::dvec3& v, double w) { return {Ring(v.x), Ring(v.y), Ring(v.z), Ring(w)}; }

/// Whether an enclosure holds the exact root.
bool holds(const RootEnclosure<double>& one, const ExactRoot& root) {
  return is_in_interval(root, one.lo, one.hi);
}

bool is_ordered(const Ray<double>& ray, const EnclosedRoots<double>& claimed) {
  double last = ray.t_min;
  for (const RootEnclosure<double>& one : claimed) {
    if (!(last <= one.lo && one.lo <= one.hi && one.hi <= ray.t_max)) return false;
    last = one.hi;
  }
  return true;
}

/// Whether the enclosures leave no t of the interval out.
bool cover(const Ray<double>& ray, const EnclosedRoots<double>& claimed) {
  double reached = ray.t_min;
  for (const RootEnclosure<double>& one : claimed) {
    if (one.lo > reached) return false;
    reached = one.hi;
  }
  return !claimed.empty() && reached >= ray.t_max;
}

void judge_certain(const RootEnclosure<double>& one, const std::vector<ExactRoot>& inside, QuadricKind kind,
                   Precision precision, EnclosureJudgement& judgement) {
  if (inside.size() != 1 || kind == QuadricKind::twice) {
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

QuadricOnLine::QuadricOnLine(const Ray<double>& ray, const implicit::Quadric<double>& quadric) {
  const Matrix m(quadric);
  const Four o = homogeneous(ray.origin, 1), d = homogeneous(ray.direction, 0);
  equation_ = solve(m.between(d, d), m.between(o, d), m.between(o, o));
}

EnclosureJudgement judge(const Ray<double>& ray, const implicit::Quadric<double>& quadric,
                         Precision precision, const EnclosedRoots<double>& claimed) {
  const QuadricOnLine line(ray, quadric);
  EnclosureJudgement judgement;
  judgement.is_ordered = is_ordered(ray, claimed);
  judgement.has_missed = line.kind() == QuadricKind::everything && !cover(ray, claimed);
  std::vector<ExactRoot> hits;
  for (const ExactRoot& root : line.roots())
    if (is_in_interval(root, ray)) hits.push_back(root);
  judgement.known = hits.size();
  if (line.kind() == QuadricKind::twice) judgement.tangents = hits.size();
  for (const ExactRoot& root : hits) {
    judgement.has_missed =
        judgement.has_missed ||
        std::none_of(claimed.begin(), claimed.end(), [&](const auto& one) { return holds(one, root); });
  }
  for (const RootEnclosure<double>& one : claimed) {
    std::vector<ExactRoot> inside;
    for (const ExactRoot& root : hits)
      if (holds(one, root)) inside.push_back(root);
    if (one.status == RootStatus::certain) {
      judge_certain(one, inside, line.kind(), precision, judgement);
    } else if (one.status == RootStatus::everywhere) {
      judgement.is_wrong_everywhere = judgement.is_wrong_everywhere || line.kind() != QuadricKind::everything;
    } else if (inside.empty() && line.kind() != QuadricKind::everything) {
      ++judgement.idle;
    }
  }
  return judgement;
}

}  // namespace rayproof::oracle
