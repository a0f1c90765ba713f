#include "leaks/judge.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "generators/random.hpp"
#include "oracle/numbers/ulp.hpp"
#include "oracle/oracle.hpp"

namespace rayproof::leaks {

namespace {

std::vector<double> hits_of(const Answer& answer) {
  const auto all = std::get<RayAnswer>(answer).hits.view();
  return {all.begin(), all.end()};
}

/// The largest magnitude of a coordinate, the origin's or the patch's.
double largest_coordinate(const std::vector<Case>& cases) {
  double largest = 0;
  for (const Case& one : cases) {
    const auto& question = std::get<RayQuestion>(one.question);
    const auto& triangle = std::get<Triangle<double>>(question.shape);
    for (const glm::dvec3& v : {question.ray.origin, triangle.a, triangle.b, triangle.c})
      largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  }
  return largest;
}

/// What is wrong with the t reported of one crossing, if anything.
std::optional<LossKind> failure_of(const PatchCrossing& crossing, const std::vector<double>& hits,
                                   Precision precision) {
  if (hits.empty()) return LossKind::leak;
  if (std::ranges::any_of(hits, [](double t) { return std::isnan(t); }))
    return std::nullopt;  // no t is given
  const auto [least, most] = std::ranges::minmax(hits);
  if (least == most) return std::nullopt;
  const glm::dvec3& d = crossing.aim.ray.direction;
  const double apart = (most - least) * std::sqrt(dot(d, d));
  const bool is_one = apart <= same_hit_ulps * oracle::ulp_of(largest_coordinate(crossing.cases), precision);
  return is_one ? std::nullopt : std::optional(LossKind::double_hit);
}

/// Whether a triangle of the patch has no answer, which is counted.
bool note_unanswered(Outcomes& into, std::uint64_t number, std::span<const Outcome> outcomes) {
  const auto failed = std::ranges::find_if(
      outcomes, [](const Outcome& one) { return one.is_failure() || one.kind == OutcomeKind::not_asked; });
  if (failed != outcomes.end()) {
    ++into.failed;
    if (failed->is_failure() && (!into.failure || number < into.failure->first))
      into.failure.emplace(number, failed->sentence);
    return true;
  }
  if (std::ranges::all_of(outcomes, &Outcome::is_answered)) return false;
  ++into.unsupported;
  return true;
}

}  // namespace

std::optional<PatchCrossing> crossing_of(const Targets& targets, std::uint64_t number, std::uint64_t seed,
                                         Precision precision) {
  const std::optional<Aim> aim = draw_aim(targets, combine(seed, number), precision);
  if (!aim) return std::nullopt;
  PatchCrossing made{number, *aim};
  std::optional<double> t;
  for (const std::size_t triangle : aim->patch) {
    made.cases.push_back(
        {.precision = precision, .question = RayQuestion{aim->ray, targets.mesh->triangle(triangle)}});
    const std::vector<double> hits = hits_of(oracle::answer(made.cases.back()));
    made.is_hit.push_back(!hits.empty());
    if (hits.empty()) continue;
    if (t && *t != hits.front()) return std::nullopt;
    t = hits.front();
  }
  return t ? std::optional(std::move(made)) : std::nullopt;
}

void judge(Outcomes& into, const PatchCrossing& crossing, std::span<const Outcome> outcomes) {
  if (note_unanswered(into, crossing.number, outcomes)) return;
  std::vector<std::vector<double>> got;
  std::vector<double> all;
  for (const Outcome& one : outcomes) {
    got.push_back(hits_of(one.answer));
    all.insert(all.end(), got.back().begin(), got.back().end());
  }
  const auto target = static_cast<std::size_t>(crossing.aim.target);
  ++into.rays.at(target);
  const std::optional<LossKind> failure = failure_of(crossing, all, into.precision);
  if (!failure) return;
  ++(*failure == LossKind::leak ? into.leaks : into.doubles).at(target);
  into.leaks_from_inside += *failure == LossKind::leak && crossing.aim.from_inside;
  std::optional<Loss>& first = into.first.at(static_cast<std::size_t>(*failure));
  if (!first || crossing.number < first->number)
    first = Loss{crossing.number, *failure, crossing.aim, crossing.cases, std::move(got), crossing.is_hit};
}

std::uint64_t Outcomes::total(const std::array<std::uint64_t, target_count>& counts) const {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

Outcomes& Outcomes::operator+=(const Outcomes& more) {
  for (std::size_t i = 0; i < target_count; ++i) {
    rays[i] += more.rays[i];
    leaks[i] += more.leaks[i];
    doubles[i] += more.doubles[i];
  }
  leaks_from_inside += more.leaks_from_inside;
  unsupported += more.unsupported;
  failed += more.failed;
  if (more.failure && (!failure || more.failure->first < failure->first)) failure = more.failure;
  for (std::size_t i = 0; i < first.size(); ++i)
    if (more.first[i] && (!first[i] || more.first[i]->number < first[i]->number)) first[i] = more.first[i];
  return *this;
}

}  // namespace rayproof::leaks
