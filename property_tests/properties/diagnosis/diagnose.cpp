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

/// Looks for the cause of the failing cases that are left, one group after the other.
class Search {
 public:
  Search(const Patient& patient, const Examination& examination)
      : patient_(patient), examination_(examination) {}

  /// What explains most of the cases, or else the largest part of them; no cause where nothing explains
  /// enough.
  [[nodiscard]] Diagnosis next(const Indices& left) const {
    const Indices small = explained_by("isolated", left);
    const bool is_isolated = 2 * small.size() > left.size();
    Diagnosis best;
    for (const Hypothesis& one : hypotheses()) {
      if (!may_be(one, is_isolated)) continue;
      const Indices cases = screened(one, left);
      if (cases.size() <= best.cases.size() || !is_enough(one, cases, left)) continue;
      if (examination_.is_contradicted(one)) continue;
      best.cause = &one;
      best.cases = cases;
      if (is_most(cases, left)) break;
    }
    return best;
  }

  [[nodiscard]] static bool is_most(const Indices& part, const Indices& whole) {
    return 100 * part.size() >= 85 * whole.size();
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

  /// A part of the cases makes a group of its own where it is no matter of luck; small changes alone must not
  /// do as much as a cure that rounds.
  [[nodiscard]] bool is_enough(const Hypothesis& one, const Indices& cases, const Indices& left) const {
    if (is_most(cases, left)) return true;
    if (cases.size() < 3 || 4 * cases.size() < left.size()) return false;
    return !one.perturbs || 3 * explained_by("isolated", cases).size() < cases.size();
  }

  const Patient& patient_;
  const Examination& examination_;
};

/// What is said of cases that nothing explains.
void describe_unknown(Diagnosis& group, const Examination& examination) {
  double worst = 0;
  for (const std::size_t i : group.cases) worst = std::max(worst, examination.error_of(i));
  group.severity = worst > 0x1p-8 ? Severity::gross : Severity::rounding;
  group.sentence = fmt::format("nothing that was tried cures it: wrong on {} {}", group.cases.size(),
                               group.cases.size() == 1 ? "case" : "cases");
}

void describe(Diagnosis& group, const Examination& examination) {
  if (group.cause == nullptr) return describe_unknown(group, examination);
  group.severity = group.cause->severity;
  group.sentence = group.cause->sentence;
  if (group.cause->change == nullptr || group.severity == Severity::gross) return;
  const auto on_boundary =
      std::ranges::count_if(group.cases, [&](std::size_t i) { return examination.is_boundary_case(i); });
  const bool is_boundary = 2 * on_boundary > static_cast<std::ptrdiff_t>(group.cases.size());
  if (group.severity == Severity::boundary && !is_boundary) group.severity = Severity::rounding;
}

}  // namespace

std::vector<Diagnosis> diagnose(const Patient& patient, std::span<const Case> failing,
                                std::span<const Case> passing) {
  const Examination examination(patient, failing, passing);
  const Search search(patient, examination);
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
  for (Diagnosis& group : groups) describe(group, examination);
  return groups;
}

bool explains(const Patient& patient, const Hypothesis& hypothesis, const Case& one) {
  const Examination examination(patient, {&one, 1}, {});
  const std::size_t only = 0;
  return !examination.explained(hypothesis, {&only, 1}).empty();
}

}  // namespace rayproof
