#include "properties/guest.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>

#include "oracle/oracle.hpp"
#include "properties/numbers.hpp"

namespace rayproof {
namespace {

/// Whether two hits, ascending, are one but for their last digits: a double root, or a rim that was met as a
/// part of the side and of the cap.
bool is_near(double t, double next, Precision precision) {
  const double share = precision == Precision::float32 ? 0x1p-18 : 0x1p-46;
  return std::abs(next - t) <= share * std::max(std::abs(t), std::abs(next));
}

/// Hits that are one but for their last digits are one where there are more than there should be.
void merge_near_hits(const Case& one, HitList& hits) {
  HitList merged;
  for (const double t : hits.view())
    if (merged.count == 0 || !is_near(merged.t.at(merged.count - 1), t, one.precision)) merged.push_back(t);
  if (merged.count == hits.count) return;
  const auto exact = std::get<RayAnswer>(oracle::answer(one));
  if (hits.count > exact.hits.count) hits = merged;
}

RayAnswer completed_hits(const Abilities& abilities, const Case& one, RayAnswer answer) {
  if (answer.hits.count > 1) merge_near_hits(one, answer.hits);
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
  if (const std::optional<Case> cut = cut_before_next_hit(one, claimed))
    return oracle::judge(*cut, RayAnswer{.nearest_only = true});
  return oracle::judge(one, claimed);
}

bool is_for_guest(const Subject& guest, const Case& one) {
  Case copy = one;
  const Domain& domain = guest.contract.domain;
  const int reach = one.precision == Precision::float32 ? domain.reach_float : domain.reach_double;
  const std::vector<CaseNumber> numbers = numbers_of(copy);
  return std::ranges::all_of(numbers, [reach](const CaseNumber& number) {
    const double x = *number.value;
    return x == 0 || std::isinf(x) || std::abs(std::ilogb(x)) <= reach;
  });
}

bool is_same_question(const Case& a, const Case& b) {
  if (a.precision != b.precision || a.question.index() != b.question.index()) return false;
  Case one = a, other = b;
  const std::vector<CaseNumber> ours = numbers_of(one), theirs = numbers_of(other);
  return std::ranges::equal(ours, theirs, [](const CaseNumber& x, const CaseNumber& y) {
    return x.field == y.field &&
           std::bit_cast<std::uint64_t>(*x.value) == std::bit_cast<std::uint64_t>(*y.value);
  });
}

}  // namespace rayproof
