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

/// What the subject says of the twin, in the terms of the case itself.
Answer seen_from(const Twin& twin, const Subject& subject) {
  return stretched(subject.answer(twin.one), 1 / twin.factor);
}

/// The scaled scene's answer where it differs from the case's, scaled back; nothing where it agrees, or where
/// the scaled answer itself left the range.
std::optional<Answer> differs_scaled(Trial& trial, const Scaling& scaling) {
  const Twin twin = scaled_twin(trial.question(), scaling);
  if (!all_within(scalable(trial), numbers_in(trial.subject().answer(twin.one)))) return std::nullopt;
  const Answer got = seen_from(twin, trial.subject());
  if (same(got, trial.claimed())) return std::nullopt;
  return got;
}

Ruling scaled(Trial& trial) {
  if (!is_scalable(trial)) return Ruling::outside;
  const bool differs = std::any_of(scalings.begin(), scalings.end(), [&](const Scaling& scaling) {
    return differs_scaled(trial, scaling).has_value();
  });
  return differs ? Ruling::broken : Ruling::held;
}

Evidence show_scaled(Trial& trial) {
  for (const Scaling& scaling : scalings) {
    const std::optional<Answer> got = differs_scaled(trial, scaling);
    if (!got) continue;
    return show_answer(
        trial.question(), *got,
        fmt::format("got is the answer after scaling lengths by 2^{} and the direction (or the equation) by "
                    "2^{}, scaled back; without scaling the method answers otherwise",
                    scaling.lengths, scaling.whole));
  }
  return show_answer(trial, "");
}

Ruling reversed(Trial& trial) {
  if (!trial.in_domain()) return Ruling::outside;
  const Answer mirrored = seen_from(reversed_twin(trial.question()), trial.subject());
  return same(mirrored, trial.claimed()) ? Ruling::held : Ruling::broken;
}

Evidence show_reversed(Trial& trial) {
  return show_answer(
      trial.question(), seen_from(reversed_twin(trial.question()), trial.subject()),
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
