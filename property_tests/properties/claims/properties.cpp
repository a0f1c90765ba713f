#include <algorithm>
#include <cmath>

#include "properties/property.hpp"

namespace rayproof {

const std::vector<Property>& properties() {
  static const std::vector<Property> all = [] {
    std::vector<Property> gathered;
    for (const auto theme : {accuracy_properties, symmetry_properties, safety_properties, details_properties,
                             doubt_properties, exact_properties, protocol_properties})
      for (const Property& property : theme()) gathered.push_back(property);
    std::stable_sort(gathered.begin(), gathered.end(),
                     [](const Property& a, const Property& b) { return a.claim < b.claim; });
    return gathered;
  }();
  return all;
}

const Property* find_property(std::string_view name) {
  for (const Property& property : properties())
    if (property.name == name) return &property;
  return nullptr;
}

Ruling ruling_of(const Property& property, Trial& trial) {
  const bool has_answer = trial.subject().function != nullptr || trial.outcome().is_answered();
  return has_answer || property.claim == Claim::answers ? property.rule(trial) : Ruling::outside;
}

unsigned spacing(const Subject& subject, const Property& property) {
  const bool is_expensive =
      subject.function == nullptr && (property.asks != nullptr || property.claim == Claim::exact);
  return is_expensive ? 4 * property.every : property.every;
}

Evidence show_answer(const Case& one, const Answer& got, std::string note) {
  const oracle::Judgement judgement = oracle::judge(one, got);
  Evidence evidence{got, oracle::answer(one), {}, std::move(note)};
  if (!judgement.wrong && std::isfinite(judgement.ulp)) evidence.error_ulp = judgement.ulp;
  return evidence;
}

Evidence show_answer(Trial& trial, std::string note) {
  return show_answer(trial.question(), trial.claimed(), std::move(note));
}

}  // namespace rayproof
