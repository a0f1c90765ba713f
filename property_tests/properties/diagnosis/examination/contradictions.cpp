/// \file
/// What the subject's right answers say against a hypothesis.

#include <algorithm>
#include <compare>
#include <glm/matrix.hpp>
#include <set>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/changes.hpp"
#include "properties/diagnosis/examination/agreement.hpp"
#include "properties/diagnosis/examination/examination.hpp"

namespace rayproof::diagnosis {
namespace {

/// What a fault may be confined to: the kind of shape, whether it is capped, and the transform.
struct FormOfCase {
  std::size_t shape = 0;
  bool is_capped = false;
  Placing placing = Placing::none;
  auto operator<=>(const FormOfCase&) const = default;
};

/// One that is not confined to what is mirrored shows under all transforms.
FormOfCase form_of(const Case& one, bool is_of_mirrored) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr) return {};
  const auto* cylinder = std::get_if<Cylinder<double>>(&asked->shape);
  const Placing placing = placing_of(one);
  return {asked->shape.index(), cylinder != nullptr && cylinder->capped,
          placing == Placing::mirrored && !is_of_mirrored ? Placing::turned : placing};
}

}  // namespace

Placing placing_of(const Case& one) {
  const RayQuestion* asked = ray_question(one);
  if (asked == nullptr || !asked->transform) return Placing::none;
  const bool is_mirrored = glm::determinant(glm::dmat3(*asked->transform)) < 0;
  return is_mirrored ? Placing::mirrored : Placing::turned;
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

/// How many hits that the subject finds are lost by the change that cures the misses.
std::size_t Examination::hits_lost(const Hypothesis& cure, std::span<const std::size_t> explained) const {
  constexpr std::size_t few = 8, enough = 24;
  const auto is_miss = [&](std::size_t i) { return !finds_something(failing_.at(i).asked.exact); };
  if (cure.asked != Asking::in_turn || !std::ranges::all_of(explained, is_miss)) return 0;
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

/// Whether the right answer to a case is not that which the hypothesis expects.
bool Examination::speaks_against(const Hypothesis& hypothesis, const Known& known, std::size_t mistake,
                                 bool finds_some) const {
  const bool may_be_excused = finds_some || hypothesis.kind == FindingKind::boundary;
  return agree(known.asked.one, *known.got, known.asked.exact, aspect_of(hypothesis)) &&
         fits(hypothesis, known, mistake) == false && !(may_be_excused && is_excused(hypothesis, known));
}

SeenWhere Examination::seen_where(const Hypothesis& hypothesis, std::span<const std::size_t> explained,
                                  Mistake mistake) const {
  SeenWhere where;
  if (hypothesis.predict == nullptr) return where;
  for (const std::size_t i : explained)
    where.is_shown.at(static_cast<std::size_t>(placing_of(failing_.at(i).asked.one))) = true;
  const std::size_t made = mistake ? *mistake : best_mistake(hypothesis, explained);
  for (const Known& known : passing_)
    if (known.got && speaks_against(hypothesis, known, made, true))
      ++where.contradicted.at(static_cast<std::size_t>(placing_of(known.asked.one)));
  return where;
}

SeenWhere& SeenWhere::operator+=(const SeenWhere& more) {
  for (std::size_t i = 0; i < is_shown.size(); ++i) {
    is_shown.at(i) = is_shown.at(i) || more.is_shown.at(i);
    contradicted.at(i) += more.contradicted.at(i);
  }
  return *this;
}

std::string_view SeenWhere::condition() const {
  constexpr std::size_t few = 3;
  const auto& [untransformed, turned, mirrored] = is_shown;
  if (untransformed || !(turned || mirrored)) return {};
  const auto& [without, under_any, under_mirror] = contradicted;
  if (!turned && under_any >= few) return ", but only under a transform that mirrors";
  return without >= few ? ", but only under a transform" : "";
}

std::size_t Examination::contradictions(const Hypothesis& hypothesis, std::span<const std::size_t> explained,
                                        Mistake mistake) const {
  if (hypothesis.change != nullptr) return hits_lost(hypothesis, explained);
  constexpr std::size_t many = 24;  // of a few mirrored ones any model may be right
  const bool is_of_mirrored = explained.size() >= many && std::ranges::all_of(explained, [&](std::size_t i) {
                                return placing_of(failing_.at(i).asked.one) == Placing::mirrored;
                              });
  std::set<FormOfCase> forms;
  for (const std::size_t i : explained) forms.insert(form_of(failing_.at(i).asked.one, is_of_mirrored));
  // Misses alone are foreseen by many a model: then nothing is excused.
  const auto finds = std::ranges::count_if(
      explained, [&](std::size_t i) { return finds_something(failing_.at(i).got.value_or(Answer{})); });
  const bool finds_some = finds > 0;
  const std::size_t made = mistake ? *mistake : best_mistake(hypothesis, explained);
  std::size_t found = 0, against_found = 0, against = 0;
  for (const Known& known : passing_) {
    if (!known.got || !(hypothesis.speaks_of_all || forms.contains(form_of(known.asked.one, is_of_mirrored))))
      continue;
    const bool is_found = finds_something(*known.got);
    found += is_found ? 1 : 0;
    if (!speaks_against(hypothesis, known, made, finds_some)) continue;
    ++against;
    against_found += is_found ? 1 : 0;
  }
  // Nor must it foresee misses of a good part of what is found.
  const bool misses_mostly = 4 * finds < static_cast<std::ptrdiff_t>(explained.size());
  return misses_mostly && against_found > 1 && 3 * against_found > found ? failing_.size() : against;
}

}  // namespace rayproof::diagnosis
