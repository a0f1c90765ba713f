/// \file
/// The causes that may explain what a subject is complained of.

#include <algorithm>
#include <iterator>

#include "properties/diagnosis/cover.hpp"
#include "properties/diagnosis/examination/sizes_of_mistakes.hpp"

namespace rayproof::diagnosis {

/// Every cause that is named for any complaint, or may be, in the order of the table; what the right answers
/// to the cases of all complaints contradict is left out.
std::vector<Cover::Candidate> Cover::candidates() const {
  std::vector<Candidate> all;
  const bool finds_none = never_finds();
  for (const Hypothesis& cause : hypotheses()) {
    if (finds_none ? !cause.is_of_no_hits : !is_named(cause)) continue;
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
  if (cause.measure != nullptr) {
    std::vector<double> sizes;
    for (const Sheet& sheet : sheets_)
      std::ranges::move(sheet.examination->sizes_of(cause, all_of(sheet.examination->failing_count())),
                        std::back_inserter(sizes));
    return usual_size(sizes);
  }
  if (!cause.is_one_of_many) return std::nullopt;
  std::size_t mistakes = 0;
  for (const Sheet& sheet : sheets_) {
    const Examination& examination = *sheet.examination;
    mistakes = std::max(mistakes, examination.mistake_count(cause, all_of(examination.failing_count())));
  }
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
        return over_all(mistake, [](const Examination&, const Indices& cases) { return cases.size(); });
      },
      [&](std::size_t mistake) {
        return over_all(mistake, [&](const Examination& examination, const Indices& cases) {
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

/// Whether the subject finds nothing in any of many cases. Whatever foresees misses explains most of them
/// then, and no more is known.
bool Cover::never_finds() const {
  constexpr std::size_t many = 128;
  std::size_t count = 0;
  for (const Sheet& sheet : sheets_) {
    if (!sheet.examination->never_finds()) return false;
    count += sheet.examination->failing_count() + sheet.examination->passing_count();
  }
  return count >= many;
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

}  // namespace rayproof::diagnosis
