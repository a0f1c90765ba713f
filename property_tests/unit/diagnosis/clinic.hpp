#pragma once
/// \file
/// Diagnoses of subjects as an engine makes them: cases from every family of the topic.

#include <algorithm>
#include <string>

#include "generators/generators.hpp"
#include "properties/diagnosis/diagnose.hpp"
#include "properties/engine/plan.hpp"
#include "properties/guests/guest.hpp"

namespace rayproof::faulty {

/// What breaks a property: some cases of each family in turn.
[[nodiscard]] inline Complaint complaint(const Subject& subject, const Property& property,
                                         Precision precision, unsigned cases = 400) {
  constexpr std::size_t enough = 64, enough_passing = 128;  // of twenty families some each
  Complaint found{.patient = patient_of(subject, property)};
  std::vector<Case> others;
  for (unsigned k = 0; k < cases && found.failing.size() < enough; ++k)
    for (const Family& family : families()) {
      if (family.topic != subject.topic || family.is_beyond_the_digits) continue;
      const Case one = family.generate(k, precision);
      if (!subject.has_own_contract && !is_for_guest(subject, one)) continue;
      Trial trial(subject, one);
      const Ruling ruling = property.rule(trial);
      if (ruling == Ruling::broken) found.failing.push_back(one);
      const bool is_right = ruling == Ruling::outside && !trial.judgement().wrong && trial.in_domain();
      if (is_right && others.size() < enough) others.push_back(one);
      if (ruling == Ruling::held && found.passing.size() < enough_passing) found.passing.push_back(one);
    }
  found.passing.insert(found.passing.end(), others.begin(), others.end());
  return found;
}

/// The faults that break the property.
[[nodiscard]] inline std::vector<Diagnosis> faults_of(const Subject& subject, const Property& property,
                                                      Precision precision, unsigned cases = 400) {
  const Complaint found = complaint(subject, property, precision, cases);
  return diagnose(found.patient, found.failing, found.passing);
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
