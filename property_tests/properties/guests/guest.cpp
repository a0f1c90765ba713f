#include "properties/guests/guest.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>

#include "oracle/oracle.hpp"
#include "properties/boundary.hpp"
#include "properties/edges.hpp"
#include "properties/numbers.hpp"
#include "properties/trial.hpp"

namespace rayproof {
namespace {

/// A share of t below which two numbers are one but for the digits that cancel in a plain method's equation.
double last_digits(Precision precision) { return precision == Precision::float32 ? 0x1p-12 : 0x1p-32; }

bool is_near(double t, double other, double share) {
  return std::abs(other - t) <= share * std::max(std::abs(t), std::abs(other));
}

/// Whether one hit may be met twice: where the line touches, or meets an edge or a rim, where the line's own
/// two hits are near each other, and inside a polygon, which may be made of triangles.
bool may_be_met_twice(const Case& one, const RayAnswer& exact, double t) {
  const double share = last_digits(one.precision);
  if (exact.contact != Contact::crossing || is_at_edge(one, t, share)) return true;
  if (std::holds_alternative<Polygon<double>>(std::get<RayQuestion>(one.question).shape)) return true;
  const HitList line = std::get<RayAnswer>(oracle::answer(on_whole_line(one))).hits;
  return line.count > 1 && is_near(line.t[0], line.t[1], share);
}

/// Hits that are one but for their last digits (a double root, or a rim that was met as a part of the side
/// and of the cap) are one where there are more than there should be, and one may be met twice.
void merge_near_hits(const Case& one, HitList& hits) {
  const auto is_again = [&](double t, double before) {
    return is_near(before, t, last_digits(one.precision));
  };
  if (std::ranges::adjacent_find(hits.view(), is_again) == hits.view().end()) return;
  const auto exact = std::get<RayAnswer>(oracle::answer(one));
  if (hits.count <= exact.hits.count) return;
  HitList merged;
  for (const double t : hits.view())
    if (merged.count == 0 || !is_again(t, merged.t.at(merged.count - 1)) || !may_be_met_twice(one, exact, t))
      merged.push_back(t);
  hits = merged;
}

/// Puts in the exact hits at a rim that are left out, where that makes up the number of hits. Point and
/// normal are of the first hit that was given: nothing is said of one that is put in before it. A ray along
/// the axis meets the caps alone: between side and cap it cannot fall.
void add_hits_at_rims(const Case& one, RayAnswer& answer) {
  const HitList& hits = answer.hits;
  const auto* asked = std::get_if<RayQuestion>(&one.question);
  if (asked == nullptr || !std::holds_alternative<Cylinder<double>>(asked->shape) || hits.count > 1) return;
  const glm::dvec3& sight = asked->ray.direction;
  if (!asked->transform && sight.x == 0 && sight.y == 0) return;
  const auto exact = std::get<RayAnswer>(oracle::answer(one));
  if (exact.hits.count <= hits.count) return;
  HitList all;
  const double share = last_digits(one.precision);
  for (const double t : exact.hits.view()) {
    const auto same = std::ranges::find_if(hits.view(), [&](double own) { return is_near(own, t, share); });
    if (same != hits.view().end())
      all.push_back(*same);
    else if (is_at_rim(one, t, share_of_rounding(one.precision)))
      all.push_back(t);
  }
  if (all.count != exact.hits.count) return;
  if (hits.count == 0 || all.t[0] != hits.t[0]) answer.point = answer.normal = std::nullopt;
  answer.hits = all;
}

/// A hit that is given by its point alone: t is where the ray passes nearest to that, for the judgement of
/// the point; it is not judged itself.
void add_t_of_point(const RayQuestion& asked, RayAnswer& answer) {
  const glm::dvec3& d = asked.ray.direction;
  answer.hits.t[0] = glm::dot(*answer.point - asked.ray.origin, d) / glm::dot(d, d);
}

RayAnswer completed_hits(const Abilities& abilities, const Case& one, RayAnswer answer) {
  if (answer.hits.count > 1) merge_near_hits(one, answer.hits);
  if (!answer.verdict_only) add_hits_at_rims(one, answer);
  if (answer.verdict_only && answer.point) add_t_of_point(std::get<RayQuestion>(one.question), answer);
  answer.nearest_only = !abilities.all_hits && answer.hits.count <= 1;
  return answer;
}

/// Where the nearest hit alone is given and is another one of the line: the case whose ray ends before that.
/// The nearer one is missed there.
std::optional<Case> cut_before_next_hit(const Case& one, const Answer& claimed) {
  const auto* got = std::get_if<RayAnswer>(&claimed);
  if (got == nullptr || !got->nearest_only || got->hits.count == 0) return std::nullopt;
  const auto exact = std::get<RayAnswer>(oracle::answer(one));
  const auto distance = [t = got->hits.t[0]](double hit) { return std::abs(hit - t); };
  if (exact.hits.count < 2 || !(distance(exact.hits.t[exact.hits.count - 1]) < distance(exact.hits.t[0])))
    return std::nullopt;
  Case cut = one;
  const double between = std::midpoint(exact.hits.t[0], exact.hits.t[1]);
  std::get<RayQuestion>(cut.question).ray.t_max =
      one.precision == Precision::float32 ? double{static_cast<float>(between)} : between;
  return cut;
}

/// Exact roots in the places of those that are not given; where one of two is, it stands for the nearer.
QuadraticAnswer<double> completed_roots(const Case& one, QuadraticAnswer<double> answer) {
  const auto exact = std::get<QuadraticAnswer<double>>(oracle::answer(one));
  const bool is_bare = answer.count > 0 && std::isnan(answer.roots[0]);
  if (answer.kind != exact.kind || (answer.count >= exact.count && !is_bare)) return answer;
  if (is_bare || answer.count == 0) return exact;
  const double given = answer.roots[0];
  answer = exact;
  const auto distance = [given](double root) { return std::abs(root - given); };
  *std::ranges::min_element(answer.roots, {}, distance) = given;
  return answer;
}

/// A box as the parallelepiped that it is; nothing for other shapes, for a box under a transform, which is
/// measured as any solid is, for one without thickness, and for a ray that runs in a face: comparing its
/// origin rounds nothing.
std::optional<Case> as_parallelepiped(const Case& one) {
  const auto* asked = std::get_if<RayQuestion>(&one.question);
  const auto* box = asked == nullptr ? nullptr : std::get_if<Box<double>>(&asked->shape);
  if (box == nullptr || asked->transform) return std::nullopt;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = asked->ray.origin[axis];
    if (asked->ray.direction[axis] == 0 && (o == box->min[axis] || o == box->max[axis])) return std::nullopt;
    if (box->min[axis] == box->max[axis]) return std::nullopt;
  }
  Case solid = one;
  std::get<RayQuestion>(solid.question).shape = as_parallelepiped(*box);
  return solid;
}

/// A guest may look whether a point of the ray lies on a face of the box, which rounds more than the t of its
/// slabs: how near the verdict is to another one is measured as of any solid.
oracle::Judgement measured_as_solid(const Case& one, const Answer& claimed, oracle::Judgement judgement) {
  const auto solid = judgement.wrong ? as_parallelepiped(one) : std::nullopt;
  if (!solid) return judgement;
  const oracle::Judgement of_solid = oracle::judge(*solid, claimed);
  judgement.margin = of_solid.wrong ? std::min(judgement.margin, of_solid.margin) : 0;
  return judgement;
}

/// Whether plain arithmetic may find no volume between a solid's edges.
bool is_flat_but_for_rounding(const Case& one) {
  const auto* asked = std::get_if<RayQuestion>(&one.question);
  const auto* solid = asked == nullptr ? nullptr : std::get_if<Parallelepiped<double>>(&asked->shape);
  if (solid == nullptr) return false;
  const auto& [a, b, c] = solid->edges;
  const double ulp = one.precision == Precision::float32 ? 0x1p-23 : 0x1p-52;
  return std::abs(glm::dot(a, glm::cross(b, c))) <=
         8 * ulp * glm::length(a) * glm::length(b) * glm::length(c);
}

}  // namespace

Answer completed(const Subject& subject, const Case& one, const Answer& given) {
  if (subject.has_own_contract) return given;
  if (const auto* hits = std::get_if<RayAnswer>(&given)) return completed_hits(subject.abilities, one, *hits);
  if (const auto* roots = std::get_if<QuadraticAnswer<double>>(&given)) {
    const bool may_lack = !subject.abilities.all_hits || (roots->count > 0 && std::isnan(roots->roots[0]));
    return may_lack ? completed_roots(one, *roots) : given;
  }
  if (subject.abilities.boundary || std::get<Position>(given) == Position::boundary) return given;
  const Answer exact = oracle::answer(one);
  return std::get<Position>(exact) == Position::boundary ? exact : given;
}

oracle::Judgement judged(const Case& one, const Answer& claimed) {
  const oracle::Judgement as_nearest = oracle::judge(one, claimed);
  if (as_nearest.ulp <= 2) return as_nearest;  // what follows takes as long as all else
  if (const std::optional<Case> cut = cut_before_next_hit(one, claimed)) {
    const RayAnswer miss{.nearest_only = true};
    return measured_as_solid(*cut, miss, oracle::judge(*cut, miss));
  }
  return measured_as_solid(one, claimed, as_nearest);
}

bool is_for_guest(const Subject& guest, const Case& one) {
  const Domain& domain = guest.contract.domain;
  const int reach = one.precision == Precision::float32 ? domain.reach_float : domain.reach_double;
  const double smallest = std::ldexp(1.0, -reach), largest = std::ldexp(1.0, reach);
  bool is_inside = true;
  each_number_of(one, [&](double x) {
    const double size = std::abs(x);
    is_inside = is_inside && (size == 0 || std::isinf(size) || (smallest <= size && size <= largest));
  });
  return is_inside && !is_flat_but_for_rounding(one);
}

bool is_same_question(const Case& a, const Case& b) {
  if (a.precision != b.precision || a.question.index() != b.question.index()) return false;
  std::vector<double> ours, theirs;
  ours.reserve(32);
  theirs.reserve(32);
  each_number_of(a, [&](double x) { ours.push_back(x); });
  each_number_of(b, [&](double x) { theirs.push_back(x); });
  return std::ranges::equal(ours, theirs, [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

}  // namespace rayproof
