#include "properties/diagnosis/examination.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/agreement.hpp"
#include "properties/diagnosis/changes.hpp"

namespace rayproof::diagnosis {
namespace {

/// An answer as a subject gives it that reports the nearest hit alone, or only whether there is one.
Answer as_reported(const Answer& predicted, const Answer& got) {
  Answer reported = predicted;
  const auto* mine = std::get_if<RayAnswer>(&got);
  auto* ray = std::get_if<RayAnswer>(&reported);
  if (ray == nullptr || mine == nullptr) return reported;
  ray->verdict_only = mine->verdict_only;
  if (mine->nearest_only) ray->hits.count = std::min<std::size_t>(ray->hits.count, 1);
  return reported;
}

/// What a fault may be confined to: the kind of shape, whether it is capped, whether there is a transform.
using Form = std::tuple<std::size_t, bool, bool>;

Form form_of(const Case& one) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr) return {};
  const auto* cylinder = std::get_if<Cylinder<double>>(&asked->shape);
  return {asked->shape.index(), cylinder != nullptr && cylinder->capped, asked->transform.has_value()};
}

/// What a claim speaks of beside verdict and t.
std::optional<Aspect> aspect_of(Claim claim) {
  if (claim == Claim::point) return Aspect::point;
  if (claim == Claim::normal) return Aspect::normal;
  if (claim == Claim::coordinates) return Aspect::coordinates;
  return std::nullopt;
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

std::vector<Examination::Known> Examination::ask(std::span<const Case> cases) const {
  const std::vector<std::optional<Answer>> answers = patient_.ask(cases);
  std::vector<Known> known;
  for (std::size_t i = 0; i < cases.size(); ++i) known.push_back({AnsweredCase(cases[i]), answers[i]});
  return known;
}

std::optional<bool> Examination::fits(const Hypothesis& hypothesis, const Known& known, std::size_t mistake) {
  if (!known.got) return std::nullopt;
  const auto& [one, exact] = known.asked;
  const Answer& got = *known.got;
  if (hypothesis.recognise != nullptr) return hypothesis.recognise(one, got, exact);
  const bool is_right = agree(one, got, exact, hypothesis.aspect);
  bool has_said = false, may_be_right = false, may_be_this = false;
  std::vector<Answer> foreseen = hypothesis.predict(one, exact);
  if (hypothesis.is_one_of_many && !foreseen.empty())
    foreseen = mistake < foreseen.size() ? std::vector{foreseen[mistake]} : std::vector<Answer>{};
  for (const Answer& predicted : foreseen) {
    const Answer reported = as_reported(predicted, got);
    if (hypothesis.aspect == Aspect::hits && is_nearer_to(one, got, reported, as_reported(exact, got)))
      return true;
    if (agree(one, as_reported(exact, got), reported, hypothesis.aspect)) {
      may_be_right = true;
      continue;
    }
    may_be_this |= !is_right && agree(one, got, reported, hypothesis.aspect);
    has_said = true;
  }
  // Of a subject that gives no t a model that foresees the right verdict, too, may say anything.
  if (may_be_this) return may_be_right && !gives_numbers(got) ? std::nullopt : std::optional(true);
  return has_said && !may_be_right ? std::optional(false) : std::nullopt;
}

std::vector<std::size_t> Examination::explained(const Hypothesis& hypothesis,
                                                std::span<const std::size_t> cases) const {
  if (hypothesis.is_asked_alone) return cured_alone(cases);
  std::vector<std::size_t> all;
  if (hypothesis.change != nullptr) {
    const bool is_of_digits = hypothesis.kind == FindingKind::rounding && hypothesis.beyond_rounding.empty();
    for (const Cured& one : cured(hypothesis, cases))
      if (!is_of_digits || !is_beyond_rounding(one.index)) all.push_back(one.index);
    return all;
  }
  all = explained_by(hypothesis, cases, best_mistake(hypothesis, cases));
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

std::size_t Examination::best_mistake(const Hypothesis& hypothesis,
                                      std::span<const std::size_t> cases) const {
  constexpr std::size_t most_mistakes = 16;
  std::size_t best = 0, most = 0;
  for (std::size_t mistake = 0; hypothesis.is_one_of_many && mistake < most_mistakes; ++mistake) {
    const std::size_t count = explained_by(hypothesis, cases, mistake).size();
    if (count > most) {
      best = mistake;
      most = count;
    }
  }
  return best;
}

/// Whether the cure that the model asks for helps in most of a few of the cases.
bool Examination::is_confirmed(const Hypothesis& model, std::span<const std::size_t> explained) const {
  constexpr std::size_t few = 8;
  if (model.confirmed_by.empty() || explained.empty()) return true;
  const auto some = explained.first(std::min(few, explained.size()));
  return 2 * cured(*find_hypothesis(model.confirmed_by), some).size() > some.size();
}

/// Whether a subject that has the fault may be right all the same: near a boundary, where the answers that
/// the model foresees are wrong by no more than rounding; and of a fault on the boundary alone where it is
/// rounded off that.
bool Examination::is_excused(const Hypothesis& hypothesis, const Known& known) {
  constexpr double near_boundary = 1024;  // units of the topic's contract
  if (hypothesis.predict == nullptr) return false;
  const Case& one = known.asked.one;
  if (hypothesis.kind == FindingKind::boundary) {
    const std::vector<double> got = numbers_in(*known.got), exact = numbers_in(known.asked.exact);
    return !got.empty() && !exact.empty() && got.front() != exact.front();
  }
  return std::ranges::any_of(hypothesis.predict(one, known.asked.exact), [&](const Answer& predicted) {
    const oracle::Judgement judgement = oracle::judge(one, as_reported(predicted, *known.got));
    return judgement.wrong && judgement.margin <= near_boundary;
  });
}

bool Examination::is_equation() const {
  return !failing_.empty() && std::holds_alternative<Quadratic<double>>(failing_.front().asked.one.question);
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

/// How many hits that the subject finds are lost by the change that cures the misses.
std::size_t Examination::hits_lost(const Hypothesis& cure, std::span<const std::size_t> explained) const {
  constexpr std::size_t few = 8, enough = 24;
  const auto is_miss = [&](std::size_t i) { return !finds_something(failing_.at(i).asked.exact); };
  if (cure.is_asked_alone || !std::ranges::all_of(explained, is_miss)) return 0;
  std::vector<std::size_t> changes;
  for (const Cured& one : cured(cure, explained.first(std::min(few, explained.size()))))
    changes.push_back(one.change);
  if (changes.empty()) return 0;
  std::ranges::sort(changes);
  const std::size_t usual = changes[changes.size() / 2];
  std::vector<Case> asked;
  for (const Known& known : passing_) {
    if (asked.size() >= enough || !known.got || !finds_something(*known.got)) continue;
    std::vector<Case> changed = cure.change(known.asked.one);
    if (usual < changed.size() && finds_something(oracle::answer(changed[usual])))
      asked.push_back(std::move(changed[usual]));
  }
  const std::vector<std::optional<Answer>> answers = patient_.ask(asked);
  const auto lost = static_cast<std::size_t>(
      std::ranges::count_if(answers, [](const auto& answer) { return answer && !finds_something(*answer); }));
  return 2 * lost > asked.size() ? failing_.size() : 0;
}

std::size_t Examination::contradictions(const Hypothesis& hypothesis,
                                        std::span<const std::size_t> explained) const {
  if (hypothesis.change != nullptr) return hits_lost(hypothesis, explained);
  std::set<Form> forms;
  for (const std::size_t i : explained) forms.insert(form_of(failing_.at(i).asked.one));
  // Misses alone are foreseen by many a model: then nothing is excused.
  const auto finds = std::ranges::count_if(
      explained, [&](std::size_t i) { return finds_something(failing_.at(i).got.value_or(Answer{})); });
  const bool finds_some = finds > 0;
  const std::size_t mistake = best_mistake(hypothesis, explained);
  std::size_t found = 0, against_found = 0, against = 0;
  for (const Known& known : passing_) {
    if (!known.got || !(hypothesis.speaks_of_all || forms.contains(form_of(known.asked.one)))) continue;
    const bool is_found = finds_something(*known.got);
    found += is_found ? 1 : 0;
    if (!agree(known.asked.one, *known.got, known.asked.exact, hypothesis.aspect) ||
        fits(hypothesis, known, mistake) != false ||
        ((finds_some || hypothesis.kind == FindingKind::boundary) && is_excused(hypothesis, known)))
      continue;
    ++against;
    against_found += is_found ? 1 : 0;
  }
  // Nor must it foresee misses of a good part of what is found.
  const bool misses_mostly = 4 * finds < static_cast<std::ptrdiff_t>(explained.size());
  return misses_mostly && against_found > 1 && 3 * against_found > found ? failing_.size() : against;
}

bool Examination::is_shown_whole(const Hypothesis& model, std::span<const std::size_t> explained) const {
  if (model.shows_more == nullptr) return true;
  return std::ranges::any_of(explained, [&](std::size_t i) {
    return model.shows_more(failing_.at(i).asked.one, failing_.at(i).asked.exact);
  });
}

bool Examination::finds_nothing(std::span<const std::size_t> cases) const {
  return std::ranges::none_of(
      cases, [&](std::size_t i) { return finds_something(failing_.at(i).got.value_or(Answer{})); });
}

bool Examination::is_beyond_rounding(std::size_t i) const {
  constexpr double generous = 1024;  // times what plain methods lose, and a share of the scene
  const Known& known = failing_.at(i);
  if (!known.got) return false;
  const auto& [one, exact] = known.asked;
  const double unit = one.precision == Precision::float32 ? 0x1p-24 : 0x1p-53;
  const oracle::Judgement judgement = oracle::judge(one, *known.got);
  const double lost = generous * judgement.far * judgement.far;
  const double error = judgement.wrong ? judgement.margin : judgement.residual;
  if (error > lost && error * unit * generous > 1) return true;
  const std::optional<Aspect> beside = aspect_of(patient_.claim);
  return beside && lost * unit * generous < 1 && !agree(one, *known.got, exact, *beside);
}

bool Examination::is_of_ordinary_size(std::size_t i) const {
  const auto& [one, exact] = failing_.at(i).asked;
  const auto is_ordinary = [](double x) {
    return x == 0 || !std::isfinite(x) || (0x1p-10 <= std::abs(x) && std::abs(x) <= 0x1p10);
  };
  bool are_all = true;
  each_number_of(one, [&](double x) { are_all = are_all && is_ordinary(x); });
  const RayQuestion* asked = ray_question(one);
  const double length = asked == nullptr ? 1 : glm::length(asked->ray.direction);
  for (const double t : numbers_in(exact)) are_all = are_all && is_ordinary(t) && is_ordinary(t * length);
  return are_all;
}

double Examination::error_of(std::size_t i) const {
  const Known& known = failing_.at(i);
  if (!known.got || std::holds_alternative<Position>(*known.got)) return HUGE_VAL;
  const std::vector<double> got = numbers_in(*known.got), exact = numbers_in(known.asked.exact);
  if (got.size() > exact.size() || got.empty() != exact.empty()) return HUGE_VAL;
  double worst = 0;
  for (std::size_t k = 0; k < got.size(); ++k)
    if (got[k] != exact[k]) worst = std::max(worst, std::abs(got[k] - exact[k]) / std::abs(exact[k]));
  return worst;
}

}  // namespace rayproof::diagnosis
