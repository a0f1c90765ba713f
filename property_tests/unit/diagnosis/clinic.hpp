#pragma once
/// \file
/// Diagnoses of subjects as an engine makes them: cases from every family of the topic.

#include <algorithm>
#include <rayproof/topics.hpp>
#include <string>

#include "generators/generators.hpp"
#include "properties/claims/promise.hpp"
#include "properties/diagnosis/diagnose.hpp"
#include "properties/plan.hpp"

namespace rayproof::faulty {

/// What a user expects of any code: the verdict and t that a plain textbook method gives.
[[nodiscard]] inline Contract expected_of(const std::string& topic) {
  const double bound = 8 * robust_bound(topic).value();
  const bool is_of_solid = topic == "sphere" || topic == "cylinder" || topic == "parallelepiped";
  Contract contract;
  contract.verdict = {.promised = bound, .far_power = is_of_solid || topic == "triangle" ? 1 : 0};
  contract.residual = {.promised = bound, .far_power = is_of_solid ? 1 : 0};
  contract.hit = {.point = {.promised = 8}, .normal = {.promised = 64}, .coordinates = {.promised = 16}};
  if (topic == "cylinder") contract.domain = {12, 110};
  if (topic == "parallelepiped") contract.domain = {16, 150};
  contract.holds = Claims{Claim::verdict, Claim::residual, Claim::ascending,   Claim::contact,
                          Claim::point,   Claim::normal,   Claim::coordinates, Claim::exact};
  return contract;
}

/// The cases on which a subject breaks a property, and some on which it keeps it.
struct Complaint {
  std::vector<Case> failing{}, passing{};
};

/// What breaks a property: some cases of each family in turn.
[[nodiscard]] inline Complaint complaint(const Subject& subject, const Property& property,
                                         Precision precision, unsigned cases = 400) {
  constexpr std::size_t enough = 64;
  Complaint found;
  for (unsigned k = 0; k < cases && found.failing.size() < enough; ++k)
    for (const Family& family : families()) {
      if (family.topic != subject.topic) continue;
      const Case one = family.generate(k, precision);
      Trial trial(subject, one);
      const Ruling ruling = property.rule(trial);
      if (ruling == Ruling::broken) found.failing.push_back(one);
      if (ruling == Ruling::held && found.passing.size() < 2 * enough) found.passing.push_back(one);
    }
  return found;
}

/// The faults that break the property.
[[nodiscard]] inline std::vector<Diagnosis> faults_of(const Subject& subject, const Property& property,
                                                      Precision precision, unsigned cases = 400) {
  const auto [failing, passing] = complaint(subject, property, precision, cases);
  return diagnose(patient_of(subject, property), failing, passing);
}

/// "unit-direction 31 | none 2": the causes by the number of their cases.
[[nodiscard]] inline std::string in_words(const std::vector<Diagnosis>& groups) {
  std::string text;
  for (const Diagnosis& group : groups)
    text += (text.empty() ? "" : " | ") + std::string(group.cause ? group.cause->name : "none") + " " +
            std::to_string(group.cases.size());
  return text;
}

}  // namespace rayproof::faulty
