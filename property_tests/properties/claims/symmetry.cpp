/// \file
/// Properties about symmetry: what scaling, reversing and moving a scene must do to its answers.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "properties/claims/answers.hpp"
#include "properties/claims/promise.hpp"
#include "properties/claims/similarity.hpp"
#include "properties/numbers.hpp"
#include "properties/property.hpp"

namespace rayproof {

namespace {

/// Powers of two for the lengths of a scene and for the length of the direction (or, for a quadratic, for its
/// roots and for the equation as a whole).
struct Scaling {
  int lengths = 0;
  int whole = 0;
};
constexpr std::array<Scaling, 3> scalings{{{1, 0}, {0, 1}, {-3, 4}}};
/// The largest shift of an exponent in `scalings`.
constexpr int scaling_reach = 4;

/// Whether the number may be scaled without leaving the subject's domain or the format's normal numbers.
bool fits(const Trial& trial, double x) {
  const bool is_float = trial.question().precision == Precision::float32;
  const int lowest =
      is_float ? std::numeric_limits<float>::min_exponent : std::numeric_limits<double>::min_exponent;
  const int reach = std::min(trial.reach(), -lowest) - 2 * scaling_reach;
  return x == 0 || std::isinf(x) ||
         (std::abs(x) >= std::ldexp(1.0, -reach) && std::abs(x) <= std::ldexp(1.0, reach));
}

/// Underflow and overflow are no business of this property: neither in the case nor in the answers.
bool is_scalable(Trial& trial) {
  Case copy = trial.question();
  return std::ranges::all_of(numbers_of(copy),
                             [&](const CaseNumber& number) { return fits(trial, *number.value); }) &&
         std::ranges::all_of(numbers_in(trial.claimed()),
                             [&](double x) { return !std::isinf(x) && fits(trial, x); }) &&
         trial.in_domain(scaling_reach);
}

/// The first scaling whose answer, scaled back, differs from the case's, and that answer; nothing where all
/// agree. A scaled answer that itself left the range is not compared.
std::optional<std::pair<Scaling, Answer>> first_difference(Trial& trial) {
  for (const Scaling& by : scalings) {
    const Twin twin = scaled_twin(trial.question(), std::ldexp(1.0, by.lengths), std::ldexp(1.0, by.whole));
    const Answer there = trial.ask(twin.one).answer;
    const Answer got = stretched(there, 1 / twin.factor);
    const bool all_fit = std::ranges::all_of(numbers_in(there), [&](double x) { return fits(trial, x); });
    if (all_fit && !same(got, trial.claimed())) return std::pair{by, got};
  }
  return std::nullopt;
}

/// The other case is a case like any other: its exact t is known, and the subject's bounds hold for it.
Ruling keeps_promise(const Trial& trial, const Case& other) {
  if (!trial.subject().has_own_contract && !is_for_guest(trial.subject(), other)) return Ruling::outside;
  const Outcome outcome = trial.ask(other);
  if (!outcome.is_answered()) return Ruling::outside;
  Trial there(trial.subject(), other);
  there.know(outcome, {});
  if (!there.in_domain()) return Ruling::outside;
  const oracle::Judgement& judgement = there.judgement();
  const Promise promise = promise_for(there);
  if (judgement.wrong) return judgement.margin <= promise.verdict ? Ruling::held : Ruling::broken;
  return !gives_numbers(there.claimed()) || judgement.residual <= promise.residual ? Ruling::held
                                                                                   : Ruling::broken;
}

/// The first of the cases whose answer breaks the promise, or null.
const Case* first_broken(const Trial& trial, const std::vector<Case>& others) {
  const auto place = std::ranges::find_if(
      others, [&](const Case& other) { return keeps_promise(trial, other) == Ruling::broken; });
  return place == others.end() ? nullptr : &*place;
}

/// A guest's answers to the other cases need not be the same bit for bit, but keep what is promised.
Ruling all_kept(const Trial& trial, const std::vector<Case>& others) {
  return first_broken(trial, others) == nullptr ? Ruling::held : Ruling::broken;
}

Evidence show_other(const Trial& trial, const std::vector<Case>& others, const std::string& note) {
  const Case* const found = first_broken(trial, others);
  const Case& other = found != nullptr ? *found : others.front();
  Trial there(trial.subject(), other);
  there.know(trial.ask(other), {});
  Evidence evidence = show_answer(other, there.claimed(), note);
  evidence.other = other;
  return evidence;
}

std::vector<Case> scaled_cases(const Case& one) {
  std::vector<Case> others;
  for (const Scaling& by : scalings)
    others.push_back(scaled_twin(one, std::ldexp(1.0, by.lengths), std::ldexp(1.0, by.whole)).one);
  return others;
}

std::vector<Case> reversed_cases(const Case& one) { return {reversed_twin(one).one}; }

std::vector<Case> moved_cases(const Case& one) {
  const std::optional<Case> other = moved_case(one);
  return other ? std::vector{*other} : std::vector<Case>{};
}

Ruling scaled(Trial& trial) {
  if (!is_scalable(trial)) return Ruling::outside;
  if (!trial.subject().has_own_contract) return all_kept(trial, scaled_cases(trial.question()));
  return first_difference(trial) ? Ruling::broken : Ruling::held;
}

Evidence show_scaled(Trial& trial) {
  if (!trial.subject().has_own_contract)
    return show_other(trial, scaled_cases(trial.question()),
                      "got and exact answer the scene with its lengths, or the direction (or the equation), "
                      "multiplied by powers of two");
  const auto found = first_difference(trial);
  if (!found) return show_answer(trial, "");
  const auto& [scaling, got] = *found;
  return show_answer(
      trial.question(), got,
      fmt::format("got is the answer after scaling lengths by 2^{} and the direction (or the equation) by "
                  "2^{}, scaled back; without scaling the method answers otherwise",
                  scaling.lengths, scaling.whole));
}

/// The answer to the case run backwards, mirrored.
Answer mirrored(Trial& trial) {
  const Twin twin = reversed_twin(trial.question());
  return stretched(trial.ask(twin.one).answer, 1 / twin.factor);
}

Ruling reversed(Trial& trial) {
  if (!trial.in_domain()) return Ruling::outside;
  if (!trial.subject().has_own_contract) return all_kept(trial, reversed_cases(trial.question()));
  return same(mirrored(trial), trial.claimed()) ? Ruling::held : Ruling::broken;
}

Evidence show_reversed(Trial& trial) {
  if (!trial.subject().has_own_contract)
    return show_other(trial, reversed_cases(trial.question()), "got and exact answer the ray run backwards");
  return show_answer(
      trial.question(), mirrored(trial),
      "got is the answer to the ray run backwards, mirrored; forwards the method answers otherwise");
}

Ruling moved(Trial& trial) {
  const std::optional<Case> other = moved_case(trial.question());
  if (!other || !trial.in_domain(scaling_reach)) return Ruling::outside;
  return keeps_promise(trial, *other);
}

Evidence show_moved(Trial& trial) {
  const char* const note = "got and exact answer the scene after an affine map moved object and ray together";
  if (!trial.subject().has_own_contract) return show_other(trial, moved_cases(trial.question()), note);
  const std::optional<Case> other = moved_case(trial.question());
  return show_answer(*other, trial.ask(*other).answer, note);
}

}  // namespace

std::vector<Property> symmetry_properties() {
  return {
      {Claim::moved, "moved", "t stays within its bounds when an affine map moves object and ray together", 4,
       moved, show_moved, nullptr, moved_cases},
      {Claim::scaled, "scaled", "scaling by powers of two changes nothing but exponents", 4, scaled,
       show_scaled, nullptr, scaled_cases},
      {Claim::reversed, "reversed", "reversing the ray mirrors its hits bit for bit", 2, reversed,
       show_reversed, nullptr, reversed_cases},
  };
}

}  // namespace rayproof
