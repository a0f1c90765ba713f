/// \file
/// What a known fault hides: the failing cases that it does not explain, looked at again.

#include <utility>

#include "properties/diagnosis/cause_search.hpp"
#include "properties/diagnosis/examination/examination.hpp"
#include "properties/engine/consultation.hpp"

namespace rayproof::diagnosis {
namespace {

/// Whether the subject gives no number: then many a model foresees what it says of a few cases.
bool says_no_more_than_whether(const Finding& finding) {
  const auto* got = std::get_if<RayAnswer>(&finding.evidence.got);
  return got == nullptr || got->verdict_only;
}

bool is_of_small_numbers(const Hypothesis* one) { return one->of_sizes == OfSizes::small; }

/// Whether a cause of what a known fault leaves may be believed: of what is small and taken for 0 if none
/// like it is known; else a model alone. What is left lies near boundaries, and where digits are lost: cures
/// say nothing of it.
bool may_be_hidden(const Hypothesis& cause, std::span<const Hypothesis* const> known) {
  if (is_of_small_numbers(&cause)) return std::ranges::none_of(known, is_of_small_numbers);
  return cause.change == nullptr;
}

}  // namespace

/// The failing cases that none of the causes explains.
std::vector<Case> Consultation::unexplained(std::vector<Case> left,
                                            std::span<const Hypothesis* const> causes) const {
  for (const Hypothesis* cause : causes) {
    const Examination examination(complaint_.patient, left, {});
    const Indices all = all_of(left.size());
    std::vector<Case> rest;
    for (const std::size_t i : without(all, examination.explained(*cause, all)))
      rest.push_back(std::move(left[i]));
    left = std::move(rest);
  }
  return left;
}

bool Consultation::turn_to_rest(std::span<const Hypothesis* const> causes) {
  constexpr std::size_t enough = 3, most = 64;
  if (sample_ == nullptr || complaint_.patient.counts_digits) return false;
  const std::vector<Case> all = in_turn(sample_->broken, sample_->broken.size());
  std::vector<Case> left = unexplained(all, causes);
  if (left.size() < enough) return false;
  broken_ = std::max<std::uint64_t>(1, broken_ * left.size() / all.size());
  complaint_.broken = static_cast<double>(broken_);
  if (left.size() > most) left.resize(most);
  hiding_ = std::exchange(complaint_.failing, std::move(left));
  add_neighbours();
  complaint_.failing = unexplained(std::move(complaint_.failing), causes);
  return complaint_.failing.size() >= enough;
}

std::vector<Finding> Consultation::findings_of_rest(const std::vector<Diagnosis>& groups,
                                                    std::span<const Hypothesis* const> known) const {
  constexpr std::size_t nearly_all = 85;  // in percent: of what lies near boundaries parts fit by chance
  std::vector<Finding> all;
  for (const Diagnosis& group : groups) {
    const Hypothesis* cause = group.cause;
    if (cause == nullptr || cause->is_vague || stop_ || std::ranges::count(known, cause) > 0) continue;
    if (100 * group.cases.size() < nearly_all * complaint_.failing.size()) continue;
    if (!may_be_hidden(*cause, known)) continue;
    if (cause->change == nullptr && says_no_more_than_whether(finding_)) continue;
    // What explains most of the other cases, too, is the same fault in other words.
    const Examination examination(complaint_.patient, hiding_, {});
    if (2 * examination.explained(*cause, all_of(hiding_.size())).size() > hiding_.size()) continue;
    if (auto other = of_group(group)) all.push_back(std::move(*other));
  }
  return all;
}

}  // namespace rayproof::diagnosis
