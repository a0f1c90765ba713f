/// \file
/// Properties about symmetry: what scaling, reversing and moving a scene must do to its answers.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "properties/claims/answers.hpp"
#include "properties/claims/promise.hpp"
#include "properties/claims/similarity.hpp"
#include "properties/numbers.hpp"
#include "properties/property.hpp"

namespace rayproof {

namespace {

struct ExponentRange {
  double lowest, highest;
  [[nodiscard]] bool contains(double x) const {
    return x == 0 || std::isinf(x) || (std::abs(x) >= lowest && std::abs(x) <= highest);
  }
};

/// The numbers that may be scaled without leaving the subject's domain or the format's normal numbers.
ExponentRange scalable(Trial& trial) {
  const bool is_float = trial.question().precision == Precision::float32;
  const int lowest =
      is_float ? std::numeric_limits<float>::min_exponent : std::numeric_limits<double>::min_exponent;
  const int reach = std::min(trial.reach(), -lowest) - 2 * scaling_reach;
  return {std::ldexp(1.0, -reach), std::ldexp(1.0, reach)};
}

bool all_within(const ExponentRange& range, const std::vector<double>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [&](double x) { return range.contains(x); });
}

/// Underflow and overflow are no business of this property: neither in the case nor in the answers.
bool is_scalable(Trial& trial) {
  const ExponentRange range = scalable(trial);
  Case copy = trial.question();
  for (const CaseNumber& number : numbers_of(copy))
    if (!range.contains(*number.value)) return false;
  const std::vector<double> claimed = numbers_in(trial.claimed());
  const bool overflows = std::any_of(claimed.begin(), claimed.end(), [](double x) { return std::isinf(x); });
  return !overflows && all_within(range, claimed) && trial.in_domain(scaling_reach);
}

/// The first scaling whose answer, scaled back, differs from the case's, and that answer; nothing where all
/// agree. A scaled answer that itself left the range is not compared.
std::optional<std::pair<Scaling, Answer>> first_difference(Trial& trial) {
  const ExponentRange range = scalable(trial);
  for (const Scaling& scaling : scalings) {
    const Twin twin = scaled_twin(trial.question(), scaling);
    const Answer there = trial.subject().answer(twin.one);
    const Answer got = stretched(there, 1 / twin.factor);
    if (all_within(range, numbers_in(there)) && !same(got, trial.claimed())) return std::pair{scaling, got};
  }
  return std::nullopt;
}

Ruling scaled(Trial& trial) {
  if (!is_scalable(trial)) return Ruling::outside;
  return first_difference(trial) ? Ruling::broken : Ruling::held;
}

Evidence show_scaled(Trial& trial) {
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
  return stretched(trial.subject().answer(twin.one), 1 / twin.factor);
}

Ruling reversed(Trial& trial) {
  if (!trial.in_domain()) return Ruling::outside;
  return same(mirrored(trial), trial.claimed()) ? Ruling::held : Ruling::broken;
}

Evidence show_reversed(Trial& trial) {
  return show_answer(
      trial.question(), mirrored(trial),
      "got is the answer to the ray run backwards, mirrored; forwards the method answers otherwise");
}

/// The moved case is a case like any other: its exact t is known, and the subject's bounds hold for it.
Ruling moved(Trial& trial) {
  const std::optional<Case> other = moved_case(trial.question());
  if (!other || !trial.in_domain(scaling_reach)) return Ruling::outside;
  Trial there(trial.subject(), *other);
  if (!there.in_domain()) return Ruling::outside;
  const oracle::Judgement& judgement = there.judgement();
  const Promise promise = promise_for(there);
  if (judgement.wrong) return judgement.margin <= promise.verdict ? Ruling::held : Ruling::broken;
  return judgement.residual <= promise.residual ? Ruling::held : Ruling::broken;
}

Evidence show_moved(Trial& trial) {
  const std::optional<Case> other = moved_case(trial.question());
  return show_answer(*other, trial.subject().answer(*other),
                     "got and exact answer the scene after an affine map moved object and ray together");
}

}  // namespace

std::vector<Property> symmetry_properties() {
  return {
      {Claim::moved, "moved", "t stays within its bounds when an affine map moves object and ray together", 4,
       moved, show_moved},
      {Claim::scaled, "scaled", "scaling by powers of two changes nothing but exponents", 4, scaled,
       show_scaled},
      {Claim::reversed, "reversed", "reversing the ray mirrors its hits bit for bit", 2, reversed,
       show_reversed},
  };
}

}  // namespace rayproof
