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

Indices common(const Indices& a, const Indices& b) {
  Indices both;
  std::ranges::set_intersection(a, b, std::back_inserter(both));
  return both;
}

Indices united(const Indices& a, const Indices& b) {
  Indices all;
  std::ranges::set_union(a, b, std::back_inserter(all));
  return all;
}

}  // namespace

Cover::Cover(std::span<const Complaint* const> complaints) {
  for (const Complaint* one : complaints) {
    Sheet sheet;
    sheet.examination = std::make_unique<Examination>(one->patient, one->failing, one->passing);
    sheet.search =
        std::make_unique<CauseSearch>(one->patient, *sheet.examination, std::span<const Hypothesis* const>{});
    sheet.named = sheet.search->likely_by_precision();
    for (const Diagnosis& group : sheet.search->groups()) sheet.named.push_back(group.cause);
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

/// Every cause that is named for any complaint, or may be, in the order of the table; what the right answers
/// to the cases of all complaints contradict is left out.
std::vector<Cover::Candidate> Cover::candidates() const {
  std::vector<Candidate> all;
  for (const Hypothesis& cause : hypotheses()) {
    if (!is_named(cause)) continue;
    Candidate candidate{&cause};
    const Examination::Mistake mistake = common_mistake(cause);
    std::size_t explained = 0, contradictions = 0;
    bool is_shown_whole = false;
    for (const Sheet& sheet : sheets_) {
      // A cure that only says where to look says nothing of lost digits.
      const bool is_of_more = sheet.counts_digits && cause.is_vague && cause.change != nullptr;
      Indices cases = is_of_more ? Indices{} : sheet.search->explained_of_all(cause, mistake);
      explained += cases.size();
      is_shown_whole = is_shown_whole || sheet.examination->is_shown_whole(cause, cases);
      const bool is_refutable = !cases.empty() || (cause.speaks_of_all && cause.change == nullptr);
      const std::size_t against = is_refutable ? sheet.examination->contradictions(cause, cases, mistake) : 0;
      contradictions += against;
      if (!cause.is_throughout) candidate.against += sheet.weight * static_cast<double>(against);
      candidate.explained.push_back(std::move(cases));
    }
    if (!is_shown_whole || is_refuted(cause, explained, contradictions)) continue;
    if (cause.is_throughout && !shows_in_numbers(candidate)) continue;
    SeenWhere where;
    for (std::size_t k = 0; k < sheets_.size(); ++k)
      where += sheets_[k].examination->seen_where(cause, candidate.explained[k], mistake);
    candidate.condition = where.condition();
    if (!candidate.condition.empty() && !is_most_somewhere(candidate)) continue;
    all.push_back(std::move(candidate));
  }
  name_by_models(all);
  return all;
}

/// Whether it explains most of what fails of one complaint: of few cases a model that is right under some
/// transforms alone fits by chance.
bool Cover::is_most_somewhere(const Candidate& candidate) const {
  for (std::size_t k = 0; k < sheets_.size(); ++k)
    if (10 * candidate.explained[k].size() >= 6 * sheets_[k].examination->failing_count()) return true;
  return false;
}

/// What all goes through shows in numbers, not in verdicts alone.
bool Cover::shows_in_numbers(const Candidate& candidate) const {
  double numbers = 0;
  for (std::size_t k = 0; k < sheets_.size(); ++k)
    numbers += sheets_[k].weight *
               static_cast<double>(sheets_[k].examination->count_of_numbers(candidate.explained[k]));
  return 4 * numbers > weight_of_common(candidate, candidate.explained);
}

/// A subject makes one mistake, whatever it is complained of: of few cases others would do as well.
Examination::Mistake Cover::common_mistake(const Hypothesis& cause) const {
  if (!cause.is_one_of_many) return std::nullopt;
  std::size_t mistakes = 0;
  for (const Sheet& sheet : sheets_) {
    const Examination& examination = *sheet.examination;
    mistakes = std::max(mistakes, examination.mistake_count(cause, all_of(examination.failing_count())));
  }
  using Cases = std::vector<std::size_t>;
  const auto over_all = [&](std::size_t mistake, auto&& counted) {
    std::size_t sum = 0;
    for (const Sheet& sheet : sheets_) {
      const Examination& examination = *sheet.examination;
      sum += counted(examination, examination.explained(cause, all_of(examination.failing_count()), mistake));
    }
    return sum;
  };
  return best_balanced(
      mistakes,
      [&](std::size_t mistake) {
        return over_all(mistake, [](const Examination&, const Cases& cases) { return cases.size(); });
      },
      [&](std::size_t mistake) {
        return over_all(mistake, [&](const Examination& examination, const Cases& cases) {
          return cases.empty() ? 0 : examination.contradictions(cause, cases, mistake);
        });
      });
}

/// Whether it is named for some complaint.
bool Cover::is_named(const Hypothesis& cause) const {
  return std::ranges::any_of(sheets_, [&](const Sheet& sheet) {
    return !(sheet.counts_digits && breaks_more_than_digits(cause)) &&
           std::ranges::count(sheet.named, &cause) > 0;
  });
}

/// How many cases of the run are explained by the candidate and are among the others.
double Cover::weight_of_common(const Candidate& one, const std::vector<Indices>& others) const {
  double sum = 0;
  for (std::size_t k = 0; k < sheets_.size(); ++k)
    sum += sheets_[k].weight * static_cast<double>(common(one.explained[k], others[k]).size());
  return sum;
}

/// The model of which a cure is the same fault in vaguer words: the cure helps in what the model explains and
/// in little more, and no other model explains the rest. Null where there is none.
Cover::Candidate* Cover::model_of(const Candidate& cure, std::vector<Candidate>& candidates) const {
  constexpr double most = 0.6, nearly_all = 0.9;
  const double all = weight_of_common(cure, cure.explained);
  for (Candidate& model : candidates) {
    const double both = weight_of_common(model, cure.explained);
    const bool is_within = both >= nearly_all * weight_of_common(model, model.explained);
    if (model.cause->change != nullptr || both < most * all || !is_within) continue;
    std::vector<Indices> rest;
    for (std::size_t k = 0; k < sheets_.size(); ++k)
      rest.push_back(without(cure.explained[k], model.explained[k]));
    const bool has_other = std::ranges::any_of(candidates, [&](const Candidate& other) {
      return other.cause->change == nullptr && 2 * weight_of_common(other, rest) > all - both;
    });
    if (both == all || !has_other) return &model;
  }
  return nullptr;
}

/// Gives the cases of such cures to their models.
void Cover::name_by_models(std::vector<Candidate>& candidates) const {
  for (std::size_t i = 0; i < candidates.size();) {
    const Candidate cure = candidates[i];
    const bool is_cure = cure.cause->change != nullptr && cure.cause->kind == FindingKind::gross;
    Candidate* const model = is_cure ? model_of(cure, candidates) : nullptr;
    if (model == nullptr) {
      ++i;
      continue;
    }
    for (std::size_t k = 0; k < sheets_.size(); ++k)
      model->explained[k] = united(model->explained[k], cure.explained[k]);
    candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(i));
  }
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
    for (std::size_t k = 0; k < sheets_.size(); ++k)
      left[k] = without(left[k], without(taken.back().explained[k], kept_for_models(taken.back(), k, open)));
  }
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
  return cases.size() >= 3 && (4 * cases.size() >= all || is_proof);
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
