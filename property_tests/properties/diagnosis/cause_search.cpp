#include "properties/diagnosis/cause_search.hpp"

#include <algorithm>

#include "properties/diagnosis/examination/agreement.hpp"

namespace rayproof::diagnosis {
namespace {

/// Whether the fault can show where the property was broken.
bool can_show(Aspect aspect, Claim claim) {
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

/// A part of the cases makes a group of its own where it is no matter of luck.
bool is_part(const Indices& cases, const Indices& left) {
  return cases.size() >= 3 && is_share(cases, left, 25);
}

}  // namespace

bool breaks_more_than_digits(const Hypothesis& one) {
  const bool is_mark = one.recognise != nullptr && (!one.is_vague || one.is_throughout);
  return one.kind == FindingKind::gross && one.of_sizes == OfSizes::nothing && !is_mark;
}

bool is_refuted(const Hypothesis& one, std::size_t explained, std::size_t contradictions) {
  const std::size_t admitted = one.speaks_of_all ? 1 : explained * one.admits / 100;
  return contradictions > std::max<std::size_t>(admitted, 1);
}

std::vector<Diagnosis> CauseSearch::groups() const {
  std::vector<Diagnosis> groups;
  for (Indices left = all_of(examination_.failing_count()); !left.empty();) {
    Diagnosis group = next(left);
    if (group.cause == nullptr) group.cases = left;
    left = without(left, group.cases);
    groups.push_back(std::move(group));
  }
  return groups;
}

Indices CauseSearch::explained_of_all(const Hypothesis& one, Examination::Mistake mistake) const {
  const Indices all = all_of(examination_.failing_count());
  if (one.asked != Asking::in_turn) return is_of_the_asking(one, all) ? all : Indices{};
  const bool is_isolated = one.perturbs && are_isolated(all, 50);
  const bool speaks_of_detail = (one.predict != nullptr || one.is_throughout) && one.aspect == Aspect::hits &&
                                detail_of(patient_.claim).has_value();
  const bool is_asked = may_be(one, is_isolated) || speaks_of_detail;
  Indices cases = is_asked ? examination_.explained(one, all, mistake) : Indices{};
  return is_too_small_a_share(one, cases) ? Indices{} : cases;
}

Diagnosis CauseSearch::next(const Indices& left) const {
  for (const std::string_view name : {"asked-alone", "asked-again"})
    if (const Hypothesis* one = find_hypothesis(name); is_of_the_asking(*one, left))
      return {.cause = one, .cases = left};
  for (const Hypothesis* one : known_)
    if (Indices cases = screened(*one, left); may_show(*one) && is_most(*one, cases, left))
      return {.cause = one, .cases = std::move(cases)};
  Diagnosis best = best_model(left, false);
  // That misses are foreseen says no more than a cure does.
  const bool is_of_misses = examination_.finds_nothing(best.cases);
  if (is_share(best.cases, left, is_of_misses ? most_for_a_cure : most_for_a_model)) return best;
  if (!is_part(best.cases, left)) best = {};
  const bool is_isolated = are_isolated(left, 50);
  for (const Hypothesis& one : hypotheses()) {
    if (one.predict != nullptr || one.measure != nullptr || one.asked != Asking::in_turn) continue;
    if (!may_be(one, is_isolated)) continue;
    const Indices cases = screened(one, left);
    const bool is_enough = is_share(cases, left, most_for_a_cure);
    if (!is_enough && (cases.size() <= best.cases.size() || !is_proven(one, cases, left))) continue;
    // Two cures at once must do clearly more than one of them.
    if (one.is_pair && 10 * best.cases.size() >= 9 * cases.size()) continue;
    if (is_contradicted(one, cases)) continue;
    best.cause = &one;
    best.cases = cases;
    if (is_enough) break;
  }
  return best;
}

/// Whether the subject answers each of the first few cases otherwise when it is asked so. When it is asked
/// again two are enough: who keeps something of the case before may be right by chance.
bool CauseSearch::is_of_the_asking(const Hypothesis& one, const Indices& left) const {
  const bool is_again = one.asked == Asking::again;
  const auto first =
      std::span<const std::size_t>(left).first(std::min<std::size_t>(is_again ? 8 : 4, left.size()));
  const std::size_t enough = is_again ? std::min<std::size_t>(2, first.size()) : first.size();
  return examination_.explained(one, first).size() >= enough;
}

bool CauseSearch::may_show(const Hypothesis& one) const {
  return one.change != nullptr || can_show(one.aspect, patient_.claim);
}

/// Where any small change cures, a cure that rounds the case anew proves nothing.
bool CauseSearch::may_be(const Hypothesis& one, bool is_isolated) const {
  if (one.change != nullptr) return !(is_isolated && one.perturbs);
  return may_show(one);
}

/// Whether small changes alone cure that share of the cases.
bool CauseSearch::are_isolated(const Indices& cases, std::size_t percent) const {
  return is_share(examination_.explained(*find_hypothesis("isolated"), cases), cases, percent);
}

/// A few cases first: most hypotheses explain none of them.
Indices CauseSearch::screened(const Hypothesis& one, const Indices& left) const {
  constexpr std::size_t few = 8;
  const std::span<const std::size_t> all(left);
  Indices cases = examination_.explained(one, all.first(std::min(few, all.size())));
  if (cases.empty() || all.size() <= few) return cases;
  const Indices more = examination_.explained(one, all.subspan(few));
  cases.insert(cases.end(), more.begin(), more.end());
  return cases;
}

bool CauseSearch::is_most(const Hypothesis& one, const Indices& cases, const Indices& left) const {
  return is_share(cases, left, one.predict != nullptr ? most_for_a_model : most_for_a_cure) &&
         !is_contradicted(one, cases);
}

/// The model that foresees most of the wrong answers, and no wrong one where the subject is right.
Diagnosis CauseSearch::best_model(const Indices& left, bool is_exact) const {
  Diagnosis best;
  std::size_t most = 0;
  for (const Hypothesis& one : hypotheses()) {
    const bool is_mark = one.predict == nullptr && one.measure == nullptr;
    if (one.change != nullptr || (is_mark && !is_exact) || !may_be(one, false)) continue;
    if (is_exact && (one.is_vague || one.is_throughout)) continue;
    if (patient_.counts_digits && breaks_more_than_digits(one)) continue;
    Indices cases = screened(one, left);
    if (10 * cases.size() <= most) continue;
    const std::size_t worth = balance(one, cases);
    if (worth <= most) continue;
    most = worth;
    best.cause = &one;
    best.cases = std::move(cases);
  }
  return best;
}

/// How many more cases a model explains than contradict it, in tenths; 0 where it is refuted or fits by
/// chance. One that says too much, of all transforms where it is seen under some, counts a tenth less.
std::size_t CauseSearch::balance(const Hypothesis& model, const Indices& cases) const {
  if (cases.empty() || is_by_chance(model, cases)) return 0;
  const std::size_t against = examination_.contradictions(model, cases);
  if (is_refuted(model, cases.size(), against)) return 0;
  const bool says_too_much = !examination_.seen_where(model, cases).condition().empty();
  const bool is_most_of_all = 10 * cases.size() >= 6 * examination_.failing_count();
  if (says_too_much && !is_most_of_all) return 0;  // of few cases that is chance
  return (says_too_much ? 9 : 10) * (cases.size() - against);
}

std::vector<const Hypothesis*> CauseSearch::named() const {
  std::vector<const Hypothesis*> named;
  const Indices all = all_of(examination_.failing_count());
  for (const Hypothesis& one : hypotheses()) {
    if (!one.differs_by_precision || !may_be(one, false)) continue;
    const Indices cases = screened(one, all);
    if (is_share(cases, all, most_for_a_model) && balance(one, cases) > 0) named.push_back(&one);
  }
  bool is_vague = false;
  for (const Diagnosis& group : groups()) {
    named.push_back(group.cause);
    is_vague = is_vague || (group.cause != nullptr && group.cause->is_vague);
  }
  if (!is_vague) return named;
  if (const Diagnosis best = best_model(all, true); is_part(best.cases, all)) named.push_back(best.cause);
  return named;
}

/// One that says more than another must be seen to.
bool CauseSearch::is_by_chance(const Hypothesis& one, const Indices& cases) const {
  return !examination_.is_shown_whole(one, cases) || is_too_small_a_share(one, cases);
}

/// A model that fits single cases by chance must explain nearly all that fail, not only those that are left.
bool CauseSearch::is_too_small_a_share(const Hypothesis& one, const Indices& cases) const {
  constexpr std::size_t few = 4;
  return one.least_share > 0 &&
         (cases.size() < few || 100 * cases.size() < one.least_share * examination_.failing_count());
}

bool CauseSearch::is_contradicted(const Hypothesis& one, const Indices& cases) const {
  return is_refuted(one, cases.size(), examination_.contradictions(one, cases));
}

/// And small changes alone must not do as much as a cure that rounds the case anew.
bool CauseSearch::is_proven(const Hypothesis& one, const Indices& cases, const Indices& left) const {
  return is_part(cases, left) && !(one.change != nullptr && one.perturbs && are_isolated(cases, 33));
}

}  // namespace rayproof::diagnosis
