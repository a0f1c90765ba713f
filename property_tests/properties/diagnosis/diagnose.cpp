#include "properties/diagnosis/diagnose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "properties/diagnosis/examination.hpp"

namespace rayproof {
namespace {

using diagnosis::Examination;
using Indices = std::vector<std::size_t>;

/// Whether the fault can show where the property was broken.
bool may_show(Aspect aspect, Claim claim) {
  switch (claim) {
    case Claim::point:
      return aspect == Aspect::point || aspect == Aspect::contact;
    case Claim::normal:
      return aspect == Aspect::normal;
    case Claim::coordinates:
      return aspect == Aspect::coordinates;
    case Claim::contact:
      return aspect == Aspect::contact;
    case Claim::exact:
      return aspect == Aspect::hits || aspect == Aspect::contact;
    default:
      return aspect == Aspect::hits;
  }
}

/// Of the cases in percent: a model that foresees an answer digit by digit says more than a cure.
constexpr std::size_t most_for_a_model = 60;
constexpr std::size_t most_for_a_cure = 85;

bool is_share(const Indices& part, const Indices& whole, std::size_t percent) {
  return 100 * part.size() >= percent * whole.size() && !part.empty();
}

/// Looks for the cause of the failing cases that are left, one group after the other.
class CauseSearch {
 public:
  CauseSearch(const Patient& patient, const Examination& examination,
              std::span<const Hypothesis* const> known)
      : patient_(patient), examination_(examination), known_(known) {}

  /// What explains most of the cases, or else the largest part of them; no cause where nothing explains
  /// enough.
  [[nodiscard]] Diagnosis next(const Indices& left) const {
    for (const Hypothesis* one : known_)
      if (Indices cases = screened(*one, left);
          may_show(one->aspect, patient_.claim) && is_most(*one, cases, left))
        return {.cause = one, .cases = std::move(cases)};
    Diagnosis best = best_model(left);
    if (is_share(best.cases, left, most_for_a_model)) return best;
    if (!is_part(best.cases, left)) best = {};
    const bool is_isolated = is_share(explained_by("isolated", left), left, 50);
    for (const Hypothesis& one : hypotheses()) {
      if (one.predict != nullptr || !may_be(one, is_isolated)) continue;
      const Indices cases = screened(one, left);
      const bool is_enough = is_share(cases, left, most_for_a_cure);
      if (!is_enough && (cases.size() <= best.cases.size() || !is_proven(one, cases, left))) continue;
      if (is_contradicted(one, cases)) continue;
      best.cause = &one;
      best.cases = cases;
      if (is_enough) break;
    }
    return best;
  }

 private:
  /// Where any small change cures, a cure that rounds the case anew proves nothing.
  [[nodiscard]] bool may_be(const Hypothesis& one, bool is_isolated) const {
    if (one.change != nullptr) return !(is_isolated && one.perturbs);
    return may_show(one.aspect, patient_.claim);
  }

  [[nodiscard]] Indices explained_by(std::string_view name, const Indices& left) const {
    return examination_.explained(*find_hypothesis(name), left);
  }

  /// A few cases first: most hypotheses explain none of them.
  [[nodiscard]] Indices screened(const Hypothesis& one, const Indices& left) const {
    constexpr std::size_t few = 8;
    const std::span<const std::size_t> all(left);
    Indices cases = examination_.explained(one, all.first(std::min(few, all.size())));
    if (cases.empty() || all.size() <= few) return cases;
    const Indices more = examination_.explained(one, all.subspan(few));
    cases.insert(cases.end(), more.begin(), more.end());
    return cases;
  }

  [[nodiscard]] bool is_most(const Hypothesis& one, const Indices& cases, const Indices& left) const {
    return is_share(cases, left, one.predict != nullptr ? most_for_a_model : most_for_a_cure) &&
           !is_contradicted(one, cases);
  }

  /// The model that foresees most of the wrong answers, and no wrong one where the subject is right.
  [[nodiscard]] Diagnosis best_model(const Indices& left) const {
    Diagnosis best;
    std::size_t most = 0;
    for (const Hypothesis& one : hypotheses()) {
      if (one.predict == nullptr || !may_be(one, false)) continue;
      const Indices cases = screened(one, left);
      if (cases.size() <= most || is_contradicted(one, cases)) continue;
      const std::size_t balance = cases.size() - examination_.contradictions(one);
      if (balance <= most) continue;
      most = balance;
      best.cause = &one;
      best.cases = cases;
    }
    return best;
  }

  /// One contradiction may be another fault, or rounding.
  [[nodiscard]] bool is_contradicted(const Hypothesis& one, const Indices& cases) const {
    return examination_.contradictions(one) > std::max<std::size_t>(cases.size() / 8, 1);
  }

  /// A part of the cases makes a group of its own where it is no matter of luck.
  [[nodiscard]] static bool is_part(const Indices& cases, const Indices& left) {
    return cases.size() >= 3 && is_share(cases, left, 25);
  }
  /// And small changes alone must not do as much as a cure that rounds the case anew.
  [[nodiscard]] bool is_proven(const Hypothesis& one, const Indices& cases, const Indices& left) const {
    return is_part(cases, left) && !(one.perturbs && is_share(explained_by("isolated", cases), cases, 33));
  }

  const Patient& patient_;
  const Examination& examination_;
  std::span<const Hypothesis* const> known_;
};

/// Whether a group after the first is no fault of its own: rounding, or two faults at once. A model that
/// foresees answers is proof enough.
bool is_rest(const Diagnosis& group, std::size_t all) {
  const bool is_model = group.cause != nullptr && group.cause->change == nullptr;
  return !is_model && 4 * group.cases.size() < all;
}

/// Small rests belong to the largest group.
void fold_rests(std::vector<Diagnosis>& groups, std::size_t all) {
  Diagnosis& largest =
      *std::ranges::max_element(groups, {}, [](const Diagnosis& one) { return one.cases.size(); });
  if (largest.cause == nullptr) return;
  for (const Diagnosis& group : groups)
    if (&group != &largest && is_rest(group, all))
      largest.cases.insert(largest.cases.end(), group.cases.begin(), group.cases.end());
  std::ranges::sort(largest.cases);
  const Hypothesis* const kept = largest.cause;
  std::erase_if(groups, [&](const Diagnosis& group) { return group.cause != kept && is_rest(group, all); });
}

/// What is said of cases that nothing explains.
void describe_unknown(Diagnosis& group, const Examination& examination) {
  double worst = 0;
  for (const std::size_t i : group.cases) worst = std::max(worst, examination.error_of(i));
  group.kind = worst > 0x1p-8 ? FindingKind::gross : FindingKind::rounding;
  group.sentence = fmt::format("nothing that was tried cures it: wrong on {} {}", group.cases.size(),
                               group.cases.size() == 1 ? "case" : "cases");
}

void describe(Diagnosis& group, const Examination& examination) {
  if (group.cause == nullptr) return describe_unknown(group, examination);
  group.kind = group.cause->kind;
  group.sentence = group.cause->sentence;
  if (group.cause->change == nullptr || group.kind == FindingKind::gross) return;
  const auto on_boundary =
      std::ranges::count_if(group.cases, [&](std::size_t i) { return examination.is_boundary_case(i); });
  const bool is_boundary = 2 * on_boundary > static_cast<std::ptrdiff_t>(group.cases.size());
  if (group.kind == FindingKind::boundary && !is_boundary) group.kind = FindingKind::rounding;
}

}  // namespace

std::vector<Diagnosis> diagnose(const Patient& patient, std::span<const Case> failing,
                                std::span<const Case> passing, std::span<const Hypothesis* const> known) {
  if (failing.empty()) return {};
  const Examination examination(patient, failing, passing);
  const CauseSearch search(patient, examination, known);
  Indices left(failing.size());
  std::iota(left.begin(), left.end(), 0);
  std::vector<Diagnosis> groups;
  while (!left.empty()) {
    Diagnosis group = search.next(left);
    if (group.cause == nullptr) group.cases = left;
    Indices rest;
    std::ranges::set_difference(left, group.cases, std::back_inserter(rest));
    left = std::move(rest);
    groups.push_back(std::move(group));
  }
  fold_rests(groups, failing.size());
  for (Diagnosis& group : groups) describe(group, examination);
  return groups;
}

bool explains(const Patient& patient, const Hypothesis& hypothesis, const Case& one) {
  const Examination examination(patient, {&one, 1}, {});
  const std::size_t only = 0;
  return !examination.explained(hypothesis, {&only, 1}).empty();
}

}  // namespace rayproof
