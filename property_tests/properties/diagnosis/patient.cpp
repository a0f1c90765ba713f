#include "properties/diagnosis/patient.hpp"

namespace rayproof {

Patient patient_of(const Subject& subject, const Property& property) {
  Patient patient;
  patient.ask = [&subject](std::span<const Case> cases) {
    std::vector<std::optional<Answer>> answers;
    for (const Case& one : cases) answers.emplace_back(subject.answer(one));
    return answers;
  };
  patient.rule = [&subject, &property](const Case& one, const Answer& answer) {
    const oracle::Judgement judgement = oracle::judge(one, answer);
    Trial trial(subject, one);
    trial.recall(answer, judgement);
    const Ruling ruling = property.rule(trial);
    // Where the verdict is wrong, an error of t is no matter: that is not held, either.
    if (ruling == Ruling::held && judgement.wrong && !property.name.ends_with("verdict"))
      return Ruling::outside;
    // A boundary's property says nothing of a case beside the boundary: there the verdict alone counts.
    const bool is_beside = property.claim == Claim::exact && ruling == Ruling::outside;
    return is_beside && !judgement.wrong ? Ruling::held : ruling;
  };
  patient.claim = property.claim;
  return patient;
}

}  // namespace rayproof
