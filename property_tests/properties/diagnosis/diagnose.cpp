#include "properties/diagnosis/diagnose.hpp"

#include "properties/diagnosis/cause_search.hpp"
#include "properties/diagnosis/cover.hpp"
#include "properties/diagnosis/groups.hpp"

namespace rayproof {

using diagnosis::CauseSearch;
using diagnosis::Examination;
using diagnosis::Indices;

std::vector<Diagnosis> diagnose(const Patient& patient, std::span<const Case> failing,
                                std::span<const Case> passing, std::span<const Hypothesis* const> known) {
  if (failing.empty()) return {};
  const Examination examination(patient, failing, passing);
  const CauseSearch search(patient, examination, known);
  std::vector<Diagnosis> groups = search.groups();
  diagnosis::finish(groups, examination);
  return groups;
}

std::vector<std::vector<Diagnosis>> diagnose_together(std::span<const Complaint* const> complaints) {
  return diagnosis::Cover(complaints).groups();
}

bool explains(const Patient& patient, const Hypothesis& hypothesis, const Case& one) {
  const Examination examination(patient, {&one, 1}, {});
  const std::size_t only = 0;
  return !examination.explained(hypothesis, {&only, 1}).empty();
}

}  // namespace rayproof
