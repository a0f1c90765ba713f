#include "properties/diagnosis/examination/examination.hpp"

#include <algorithm>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/examination/agreement.hpp"
#include "properties/diagnosis/examination/sizes_of_mistakes.hpp"

namespace rayproof::diagnosis {
namespace {

/// All that the model foresees; of one that measures a mistake what it does of that size.
std::vector<Answer> foreseen_by(const Hypothesis& model, const Case& one, const Answer& exact,
                                std::size_t mistake) {
  if (model.measure == nullptr) return model.predict(one, exact);
  const double size = size_of_number(mistake);
  return model.predict_of_size == nullptr || size == 0 ? std::vector<Answer>{}
                                                       : model.predict_of_size(one, exact, size);
}

/// Whether two answers have one normal, or one of them has none.
bool has_same_normal(const Answer& a, const Answer& b) {
  const auto *first = std::get_if<RayAnswer>(&a), *second = std::get_if<RayAnswer>(&b);
  if (first == nullptr || second == nullptr || !first->normal || !second->normal) return true;
  return !(glm::length(*first->normal - *second->normal) > 0);  // true for NaN, too
}

}  // namespace

Examination::Examination(const Patient& patient, std::span<const Case> failing, std::span<const Case> passing)
    : patient_(patient), failing_(ask(failing)), passing_(ask(passing)) {
  // A miss does not show whether its subject would have given t.
  const auto is_without_t = [](const Known& known) { return known.got && !gives_numbers(*known.got); };
  if (std::ranges::none_of(failing_, is_without_t) && std::ranges::none_of(passing_, is_without_t)) return;
  for (auto* const all : {&failing_, &passing_})
    for (Known& known : *all)
      if (auto* ray = known.got ? std::get_if<RayAnswer>(&*known.got) : nullptr) ray->verdict_only = true;
}

/// Whether the subject finds nothing where there is something, or fewer hits than there are, or its first one
/// beyond the exact one.
bool Examination::has_lost_a_hit(const Known& known) {
  if (!known.got || !finds_something(known.asked.exact)) return false;
  const std::vector<double> got = numbers_in(*known.got), exact = numbers_in(known.asked.exact);
  return !finds_something(*known.got) || got.empty() || exact.empty() || got.front() > exact.front() ||
         got.size() < exact.size();
}

std::vector<Examination::Known> Examination::ask(std::span<const Case> cases) const {
  const std::vector<std::optional<Answer>> answers = patient_.ask(cases);
  std::vector<Known> known;
  for (std::size_t i = 0; i < cases.size(); ++i) known.push_back({AnsweredCase(cases[i]), answers[i]});
  return known;
}

Aspect Examination::aspect_of(const Hypothesis& hypothesis) const {
  const bool is_of_hits = hypothesis.aspect == Aspect::hits && hypothesis.predict != nullptr;
  return is_of_hits ? detail_of(patient_.claim).value_or(Aspect::hits) : hypothesis.aspect;
}

std::optional<bool> Examination::fits(const Hypothesis& hypothesis, const Known& known,
                                      std::size_t mistake) const {
  if (!known.got) return std::nullopt;
  const Case& one = known.asked.one;
  const Answer& exact = known.asked.exact;
  const Answer& got = *known.got;
  if (hypothesis.recognise != nullptr) return hypothesis.recognise(one, got, exact);
  if (hypothesis.measure != nullptr)
    if (const auto size = hypothesis.measure(one, got, exact)) return is_of_size(*size, mistake);
  const Aspect aspect = aspect_of(hypothesis);
  const bool is_of_detail = aspect != Aspect::hits && aspect != Aspect::contact;
  if (Answer said = got; is_of_detail && !says_detail(one, said, aspect)) return std::nullopt;
  // A detail is foreseen with the hit that it belongs to.
  const auto agrees = [&](const Answer& some, const Answer& other) {
    return agree(one, some, other, aspect) && agree(one, some, other, hypothesis.aspect);
  };
  const bool is_right = agrees(got, exact);
  bool has_said = false, may_be_right = false, may_be_this = false;
  std::vector<Answer> foreseen = foreseen_by(hypothesis, one, exact, mistake);
  if (hypothesis.is_one_of_many && !foreseen.empty())
    foreseen = mistake < foreseen.size() ? std::vector{foreseen[mistake]} : std::vector<Answer>{};
  for (const Answer& predicted : foreseen) {
    Answer reported = as_reported(predicted, got);
    if (aspect != hypothesis.aspect && !says_detail(one, reported, aspect)) continue;
    if (aspect == Aspect::hits && is_nearer_to(one, got, reported, as_reported(exact, got))) return true;
    if (agrees(as_reported(exact, got), reported)) {
      may_be_right = true;
      continue;
    }
    may_be_this |= !is_right && agrees(got, reported);
    has_said = true;
  }
  // Of a subject that gives no t a model that foresees the right verdict, too, may say anything.
  if (may_be_this) return may_be_right && !gives_numbers(got) ? std::nullopt : std::optional(true);
  return has_said && !may_be_right ? std::optional(false) : std::nullopt;
}

std::vector<std::size_t> Examination::explained(const Hypothesis& hypothesis,
                                                std::span<const std::size_t> cases, Mistake mistake) const {
  if (hypothesis.asked == Asking::alone) return cured_alone(cases);
  if (hypothesis.asked == Asking::again) return changed_again(cases);
  std::vector<std::size_t> all;
  if (hypothesis.change != nullptr) {
    const bool is_of_digits = hypothesis.kind == FindingKind::rounding && hypothesis.beyond_rounding.empty();
    for (const Cured& one : cured(hypothesis, cases))
      if (!(is_of_digits && is_beyond_rounding(one.index)) &&
          !(hypothesis.is_of_lost_hits && !has_lost_a_hit(failing_.at(one.index))))
        all.push_back(one.index);
    return all;
  }
  all = explained_by(hypothesis, cases, mistake ? *mistake : best_mistake(hypothesis, cases));
  return is_confirmed(hypothesis, all) ? all : std::vector<std::size_t>{};
}

std::vector<std::size_t> Examination::explained_by(const Hypothesis& hypothesis,
                                                   std::span<const std::size_t> cases,
                                                   std::size_t mistake) const {
  std::vector<std::size_t> all;
  for (const std::size_t i : cases)
    if (fits(hypothesis, failing_.at(i), mistake) == true) all.push_back(i);
  return all;
}

std::vector<double> Examination::sizes_of(const Hypothesis& model, std::span<const std::size_t> cases) const {
  std::vector<double> sizes;
  for (const std::size_t i : cases) {
    const Known& known = failing_.at(i);
    const auto size =
        known.got ? model.measure(known.asked.one, *known.got, known.asked.exact) : std::nullopt;
    if (size && *size != 0) sizes.push_back(*size);
  }
  return sizes;
}

std::size_t Examination::mistake_count(const Hypothesis& model, std::span<const std::size_t> cases) const {
  std::size_t count = 0;
  for (const std::size_t i : cases) {
    const auto& [one, exact] = failing_.at(i).asked;
    count = std::max(count, model.predict(one, exact).size());
  }
  return count;
}

std::size_t Examination::best_mistake(const Hypothesis& hypothesis,
                                      std::span<const std::size_t> cases) const {
  if (hypothesis.measure != nullptr) return usual_size(sizes_of(hypothesis, cases));
  if (!hypothesis.is_one_of_many) return 0;
  return best_balanced(
      mistake_count(hypothesis, cases),
      [&](std::size_t mistake) { return explained_by(hypothesis, cases, mistake).size(); },
      [&](std::size_t mistake) {
        return contradictions(hypothesis, explained_by(hypothesis, cases, mistake), mistake);
      });
}

/// Whether the cure that the model asks for helps in most of a few of the cases.
bool Examination::is_confirmed(const Hypothesis& model, std::span<const std::size_t> explained) const {
  constexpr std::size_t few = 8;
  if (model.confirmed_by.empty() || explained.empty()) return true;
  const auto some = explained.first(std::min(few, explained.size()));
  return 2 * cured(*find_hypothesis(model.confirmed_by), some).size() > some.size();
}

std::vector<std::size_t> Examination::cured_alone(std::span<const std::size_t> cases) const {
  std::vector<std::size_t> all;
  if (!patient_.ask_alone) return all;
  for (const std::size_t i : cases) {
    const Case& one = failing_.at(i).asked.one;
    const auto answer = patient_.ask_alone(one);
    if (!answer || patient_.rule(one, *answer) != Ruling::held) break;  // each costs a process
    all.push_back(i);
  }
  return all;
}

std::vector<std::size_t> Examination::changed_again(std::span<const std::size_t> cases) const {
  // In the other order, for who keeps something of the case before.
  std::vector<Case> asked;
  for (auto i = cases.rbegin(); i != cases.rend(); ++i) asked.push_back(failing_.at(*i).asked.one);
  std::vector<std::optional<Answer>> answers = patient_.ask(asked);
  std::reverse(answers.begin(), answers.end());
  std::vector<std::size_t> all;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const std::optional<Answer>& before = failing_.at(cases[k]).got;
    if (before && answers[k] && !(same(*before, *answers[k]) && has_same_normal(*before, *answers[k])))
      all.push_back(cases[k]);
  }
  return all;
}

std::vector<Examination::Cured> Examination::cured(const Hypothesis& hypothesis,
                                                   std::span<const std::size_t> cases) const {
  std::vector<Case> asked;
  std::vector<Cured> made_by;
  for (const std::size_t i : cases) {
    std::vector<Case> changes = hypothesis.change(failing_.at(i).asked.one);
    for (std::size_t k = 0; k < changes.size(); ++k) {
      if (!is_same_question(failing_.at(i).asked, AnsweredCase(changes[k]), hypothesis.keeps)) continue;
      asked.push_back(std::move(changes[k]));
      made_by.push_back({i, k});
    }
  }
  const std::vector<std::optional<Answer>> answers = patient_.ask(asked);
  std::vector<Cured> all;
  for (std::size_t k = 0; k < asked.size(); ++k) {
    if (!all.empty() && all.back().index == made_by[k].index) continue;
    if (answers[k] && patient_.rule(asked[k], *answers[k]) == Ruling::held) all.push_back(made_by[k]);
  }
  return all;
}

bool Examination::is_shown_whole(const Hypothesis& model, std::span<const std::size_t> explained) const {
  if (model.shows_more == nullptr) return true;
  return std::ranges::any_of(explained, [&](std::size_t i) {
    return model.shows_more(failing_.at(i).asked.one, failing_.at(i).asked.exact);
  });
}

std::size_t Examination::count_of_numbers(std::span<const std::size_t> cases) const {
  return static_cast<std::size_t>(std::ranges::count_if(cases, [&](std::size_t i) {
    const Known& known = failing_.at(i);
    return known.got && !oracle::judge(known.asked.one, *known.got).wrong;
  }));
}

bool Examination::run_along_surface(std::span<const std::size_t> cases) const {
  return std::ranges::all_of(cases, [&](std::size_t i) {
    const auto* exact = std::get_if<RayAnswer>(&failing_.at(i).asked.exact);
    return exact != nullptr && (exact->contact == Contact::parallel || exact->contact == Contact::in_surface);
  });
}

bool Examination::finds_nothing(std::span<const std::size_t> cases) const {
  return std::ranges::none_of(
      cases, [&](std::size_t i) { return finds_something(failing_.at(i).got.value_or(Answer{})); });
}

bool Examination::never_finds() const {
  const auto finds = [](const Known& known) { return known.got && finds_something(*known.got); };
  return std::ranges::none_of(failing_, finds) && std::ranges::none_of(passing_, finds);
}

}  // namespace rayproof::diagnosis
