#include "properties/engine/diagnosing.hpp"

#include <tbb/parallel_for.h>

#include <iterator>
#include <map>

#include "properties/engine/consultation.hpp"

namespace rayproof {
namespace {

bool can_be_diagnosed(const Finding& finding) {
  return finding.property->claim != Claim::answers && !finding.subject->is_given_up();
}

/// Whether a boundary's finding says no more than that it is one.
bool is_vague(const Finding& finding) {
  const bool is_avoided =
      finding.cause == nullptr || (finding.cause->keeps == Keeps::verdict && !finding.cause->perturbs);
  return finding.property->claim == Claim::exact && is_avoided;
}

void adopt(Finding& finding, const Finding& from) {
  finding.cause = from.cause;
  finding.kind_of_fault = from.kind_of_fault;
  finding.diagnosis = from.diagnosis;
}

/// All findings of one subject, those of its symmetries last: they are broken by what is wrong with its
/// answers themselves, where that is known.
std::vector<Finding> diagnose_subject(RunResult& result, const std::vector<std::size_t>& of_subject,
                                      const Samples& samples, const std::atomic<bool>& stop) {
  std::vector<const Hypothesis*> known;
  std::vector<Finding> others;
  const Finding* first = nullptr;
  for (const bool are_symmetries : {false, true})
    for (const std::size_t i : of_subject) {
      Finding& finding = result.findings[i];
      if (stop || !can_be_diagnosed(finding) || breaks_symmetry(finding) != are_symmetries) continue;
      if (are_symmetries && first != nullptr) {
        adopt(finding, *first);
        finding.cases = diagnosis::broken_cases(result, finding);
        continue;
      }
      std::vector<Finding> more = diagnosis::Consultation(result, samples, finding, stop).findings(known);
      std::ranges::move(more, std::back_inserter(others));
      if (first != nullptr && is_vague(finding)) adopt(finding, *first);
      const bool is_worse = first == nullptr || finding.cases > first->cases;
      if (!are_symmetries && finding.cause != nullptr && is_worse) first = &finding;
    }
  return others;
}

}  // namespace

void diagnose_findings(RunResult& result, const Samples& samples, const Listener& listener,
                       const std::atomic<bool>& stop) {
  listener.progress("what cures the findings", 1);
  std::map<const Subject*, std::vector<std::size_t>> by_subject;
  for (std::size_t i = 0; i < result.findings.size(); ++i)
    by_subject[result.findings[i].subject].push_back(i);
  std::vector<std::vector<std::size_t>> subjects_found;
  for (const Finding& finding : result.findings)
    if (auto node = by_subject.extract(finding.subject)) subjects_found.push_back(std::move(node.mapped()));
  std::vector<std::vector<Finding>> others(subjects_found.size());
  tbb::parallel_for(std::size_t{0}, subjects_found.size(), [&](std::size_t i) {
    others[i] = diagnose_subject(result, subjects_found[i], samples, stop);
  });
  for (const std::vector<Finding>& some : others)
    for (const Finding& finding : some) {
      listener.broken(finding);
      listener.finding(finding);
      result.findings.push_back(finding);
    }
}

}  // namespace rayproof
