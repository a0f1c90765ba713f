#include "properties/diagnosis/patient.hpp"

#include <memory>

#include "properties/guests/guest.hpp"

namespace rayproof {
namespace {

/// An instance of the subject, started when it is first asked: to start a program takes longer than to ask
/// it.
using Instance = std::shared_ptr<std::unique_ptr<Answerer>>;

/// Asks the instance all cases at once; nobody is given cases that are not for him.
std::vector<std::optional<Answer>> answers_of(const Subject& subject, const Instance& instance,
                                              std::span<const Case> cases) {
  std::vector<std::optional<Answer>> answers(cases.size());
  std::vector<Case> asked;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (subject.is_given_up() || (!subject.has_own_contract && !is_for_guest(subject, cases[i]))) continue;
    asked.push_back(cases[i]);
    places.push_back(i);
  }
  if (asked.empty()) return answers;
  std::vector<Outcome> outcomes(asked.size());
  if (!*instance) *instance = subject.start();
  (*instance)->answer(asked, outcomes);
  for (std::size_t k = 0; k < asked.size(); ++k)
    if (outcomes[k].is_answered()) answers[places[k]] = completed(subject, asked[k], outcomes[k].answer);
  return answers;
}

std::optional<Answer> answer_alone(const Subject& subject, const Case& one) {
  if (subject.is_given_up() || (!subject.has_own_contract && !is_for_guest(subject, one)))
    return std::nullopt;
  const std::unique_ptr<Answerer> own = subject.start();
  own->forget();
  const Outcome outcome = own->answer(one);
  return outcome.is_answered() ? std::optional(completed(subject, one, outcome.answer)) : std::nullopt;
}

/// What a property says of an answer to a changed case.
Ruling ruling_on(const Subject& subject, const Property& property, const Case& one, const Answer& answer) {
  const oracle::Judgement judgement =
      subject.has_own_contract ? oracle::judge(one, answer) : judged(one, answer);
  Trial trial(subject, one);
  trial.know({.answer = answer}, {});
  trial.recall(answer, judgement);
  const Ruling ruling = ruling_of(property, trial);
  // Where the verdict is wrong, an error of t is no matter: that is not held, either.
  if (ruling == Ruling::held && judgement.wrong && !property.name.ends_with("verdict"))
    return Ruling::outside;
  // A boundary's property says nothing of a case beside the boundary: there the verdict alone counts.
  const bool is_beside = property.claim == Claim::exact && ruling == Ruling::outside;
  return is_beside && !judgement.wrong ? Ruling::held : ruling;
}

}  // namespace

Patient patient_of(const Subject& subject, const Property& property) {
  Patient patient;
  patient.ask = [&subject, instance = std::make_shared<std::unique_ptr<Answerer>>()](
                    std::span<const Case> cases) { return answers_of(subject, instance, cases); };
  if (subject.function == nullptr)
    patient.ask_alone = [&subject](const Case& one) { return answer_alone(subject, one); };
  patient.rule = [&subject, &property](const Case& one, const Answer& answer) {
    return ruling_on(subject, property, one, answer);
  };
  patient.claim = property.claim;
  patient.counts_digits = property.name == "digits";
  return patient;
}

}  // namespace rayproof
