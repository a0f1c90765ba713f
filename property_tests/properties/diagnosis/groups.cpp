#include "properties/diagnosis/groups.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "properties/diagnosis/examination/sizes_of_mistakes.hpp"

namespace rayproof::diagnosis {
namespace {

/// Whether a group after the first is no fault of its own: rounding, or two faults at once. A model that is
/// not vague is proof enough.
bool is_rest(const Diagnosis& group, std::size_t all) {
  const bool is_model = group.cause != nullptr && group.cause->change == nullptr && !group.cause->is_vague;
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

/// Whether the fault has to do with sizes, and next to no case of ordinary size shows it.
bool is_of_sizes_alone(const Diagnosis& group, const Examination& examination) {
  const OfSizes sizes = group.cause->of_sizes;
  if (sizes != OfSizes::small && sizes != OfSizes::limit && sizes != OfSizes::extremes) return false;
  const auto ordinary =
      std::ranges::count_if(group.cases, [&](std::size_t i) { return examination.is_of_ordinary_size(i); });
  return 10 * ordinary < static_cast<std::ptrdiff_t>(group.cases.size());
}

void describe(Diagnosis& group, const Examination& examination) {
  const auto beyond =
      std::ranges::count_if(group.cases, [&](std::size_t i) { return examination.is_beyond_rounding(i); });
  group.is_beyond_rounding = 2 * beyond > static_cast<std::ptrdiff_t>(group.cases.size());
  if (group.cause == nullptr) return describe_unknown(group, examination);
  group.kind = group.cause->kind;
  const std::string_view own_words = examination.asks<Quadratic<double>>()         ? group.cause->of_equation
                                     : examination.asks<PointAndPolygon<double>>() ? group.cause->of_point
                                                                                   : std::string_view();
  const bool has_own_words = !own_words.empty();
  group.sentence = has_own_words ? own_words : group.cause->sentence;
  if (group.cause->measure != nullptr) {
    const double size = mean_of_usual(examination.sizes_of(*group.cause, group.cases));
    group.sentence += fmt::format(", about {:.6g}", group.cause->is_factor ? 1 + size : size);
  }
  if (group.cause->asked != Asking::in_turn && examination.run_along_surface(group.cases))
    group.sentence +=
        "; it is seen where the ray runs along the surface alone: what is given there is what was left from "
        "the case before";
  if (group.kind == FindingKind::gross && is_of_sizes_alone(group, examination))
    group.kind = FindingKind::range;
  if (group.cause->change == nullptr || group.kind == FindingKind::gross) return;
  if (group.is_beyond_rounding && !group.cause->beyond_rounding.empty()) {
    group.kind = FindingKind::gross;
    if (!has_own_words) group.sentence = group.cause->beyond_rounding;
    return;
  }
  const auto on_boundary =
      std::ranges::count_if(group.cases, [&](std::size_t i) { return examination.is_boundary_case(i); });
  const bool is_boundary = 2 * on_boundary > static_cast<std::ptrdiff_t>(group.cases.size());
  if (group.kind == FindingKind::boundary && !is_boundary)
    group.kind = group.is_beyond_rounding ? FindingKind::gross : FindingKind::rounding;
}

}  // namespace

void finish(std::vector<Diagnosis>& groups, const Examination& examination) {
  fold_rests(groups, examination.failing_count());
  for (Diagnosis& group : groups) describe(group, examination);
}

}  // namespace rayproof::diagnosis
