#include "properties/diagnosis/cover.hpp"

#include <algorithm>

#include "properties/diagnosis/groups.hpp"

namespace rayproof::diagnosis {
namespace {

/// What a case counts that is explained so: a model foresees an answer digit by digit, and most cures of
/// digits and boundaries help against other faults, too, as do two cures at once.
double weight_of(const Hypothesis& cause) {
  if (cause.change == nullptr) return 1.4;
  return cause.kind == FindingKind::gross && !cause.is_pair ? 1.0 : 0.8;
}

/// Of those that are nearly as good as the best the first in the table, which is the more specific one, is
/// taken. A model that is not vague is right digit by digit, and is rivalled by less; by none that differs in
/// a size alone. But digits of a shorter type prove that type where a ray that is missed shows only how much
/// was lost.
constexpr double nearly_as_good(const Hypothesis& cause) {
  if (cause.change != nullptr || cause.is_vague) return 0.85;
  if (cause.of_sizes == OfSizes::type) return 0.9;
  return cause.of_sizes == OfSizes::nothing ? 0.97 : 1;
}

}  // namespace

Cover::Cover(std::span<const Complaint* const> complaints) {
  for (const Complaint* one : complaints) {
    Sheet sheet;
    sheet.examination = std::make_unique<Examination>(one->patient, one->failing, one->passing);
    sheet.search =
        std::make_unique<CauseSearch>(one->patient, *sheet.examination, std::span<const Hypothesis* const>{});
    sheet.named = sheet.search->named();
    const auto count = static_cast<double>(one->failing.size());
    sheet.weight = one->broken > 0 ? one->broken / count : 1;
    sheet.counts_digits = one->patient.counts_digits;
    sheets_.push_back(std::move(sheet));
  }
}

std::vector<std::vector<Diagnosis>> Cover::groups() const {
  const std::vector<Candidate> causes = chosen();
  std::vector<std::vector<Diagnosis>> all;
  for (std::size_t k = 0; k < sheets_.size(); ++k) all.push_back(groups_of(k, causes));
  return all;
}

/// The causes, that which explains most first, each with what those before it leave.
std::vector<Cover::Candidate> Cover::chosen() const {
  std::vector<Candidate> open = candidates(), taken;
  std::vector<Indices> left;
  for (const Sheet& sheet : sheets_) left.push_back(all_of(sheet.examination->failing_count()));
  while (true) {
    std::vector<double> worth;
    for (const Candidate& one : open) {
      std::vector<Indices> gained(sheets_.size());
      for (std::size_t k = 0; k < sheets_.size(); ++k)
        if (is_group(one, k, left[k])) gained[k] = left[k];
      const double share = one.condition.empty() ? 1 : 0.9;  // it says too much
      worth.push_back(weight_of(*one.cause) * share *
                      std::max(0.0, weight_of_common(one, gained) - one.against));
    }
    const double most = worth.empty() ? 0 : std::ranges::max(worth);
    if (most == 0) return taken;
    const auto first = std::ranges::max_element(worth) - worth.begin();
    const double nearly = nearly_as_good(*open[static_cast<std::size_t>(first)].cause);
    const auto best = std::ranges::find_if(worth, [&](double one) { return one >= nearly * most; });
    const auto place = open.begin() + (best - worth.begin());
    taken.push_back(std::move(*place));
    open.erase(place);
    take_other_limits(taken.back(), open);
    for (std::size_t k = 0; k < sheets_.size(); ++k)
      left[k] = without(left[k], without(taken.back().explained[k], kept_for_models(taken.back(), k, open)));
  }
}

/// Two limits of one kind are one fault, of which the one that explains more is nearer to the limit.
void Cover::take_other_limits(Candidate& taken, std::vector<Candidate>& open) {
  const std::string_view stem = stem_of_limit(taken.cause->name);
  if (stem.empty()) return;
  for (const Candidate& one : open)
    if (stem_of_limit(one.cause->name) == stem)
      for (std::size_t k = 0; k < one.explained.size(); ++k)
        taken.explained[k] = united(taken.explained[k], one.explained[k]);
  std::erase_if(open, [&](const Candidate& one) { return stem_of_limit(one.cause->name) == stem; });
}

/// The cases of a complaint that a cure helps in which only avoids what is asked, and that a model foresees.
Indices Cover::kept_for_models(const Candidate& cure, std::size_t complaint,
                               std::span<const Candidate> open) const {
  Indices kept;
  const bool avoids =
      cure.cause->change != nullptr && cure.cause->keeps == Keeps::verdict && !cure.cause->perturbs;
  for (const Candidate& one : open)
    if (avoids && one.cause->change == nullptr) kept = united(kept, one.explained[complaint]);
  return kept;
}

/// Whether what is left of the complaint is enough for a group: a good part of it, or a model's proof.
bool Cover::is_group(const Candidate& one, std::size_t complaint, const Indices& left) const {
  const Indices &explained = one.explained[complaint], cases = common(explained, left);
  const std::size_t all = sheets_[complaint].examination->failing_count();
  if (cases.empty()) return false;
  if (cases.size() == all) return true;
  const bool is_proof =
      one.cause->change == nullptr && !one.cause->is_vague && 5 * cases.size() >= 3 * explained.size();
  // A sixteenth at least: what is left of a model that explains the rest fits others by chance.
  return cases.size() >= 3 && (4 * cases.size() >= all || (is_proof && 16 * cases.size() >= all));
}

/// Of the causes chosen, those that explain most of this complaint.
std::vector<Diagnosis> Cover::groups_of(std::size_t complaint, std::span<const Candidate> causes) const {
  std::vector<Diagnosis> groups;
  Indices left = all_of(sheets_[complaint].examination->failing_count());
  while (!left.empty()) {
    Diagnosis best;
    double most = 0;
    for (const Candidate& one : causes) {
      Indices cases = common(one.explained[complaint], left);
      const double worth = weight_of(*one.cause) * static_cast<double>(cases.size());
      if (worth <= most || !is_group(one, complaint, left)) continue;
      most = worth;
      best.cause = one.cause;
      best.cases = std::move(cases);
    }
    if (best.cause == nullptr) best.cases = left;
    left = without(left, best.cases);
    groups.push_back(std::move(best));
  }
  finish(groups, *sheets_[complaint].examination);
  for (Diagnosis& group : groups) {
    const auto named = std::ranges::find(causes, group.cause, &Candidate::cause);
    if (group.cause != nullptr && named != causes.end()) group.sentence += named->condition;
  }
  return groups;
}

}  // namespace rayproof::diagnosis
