/// \file
/// The property of programs: that they answer at all.

#include "properties/property.hpp"

namespace rayproof {

namespace {

Ruling answers(Trial& trial) {
  const Outcome& outcome = trial.outcome();
  if (outcome.is_failure()) return Ruling::broken;
  return outcome.is_answered() ? Ruling::held : Ruling::outside;
}

Evidence show_outcome(Trial& trial) {
  const Outcome& outcome = trial.outcome();
  const Answer exact = oracle::answer(trial.question());
  if (outcome.is_answered()) return {trial.claimed(), exact, {}, "asked again, it answers the case"};
  return {exact, exact, {}, "the program " + outcome.sentence, outcome.sentence};
}

}  // namespace

std::vector<Property> protocol_properties() {
  return {{Claim::answers, "answers", "every valid case gets one answer, in time", 1, answers, show_outcome}};
}

}  // namespace rayproof
