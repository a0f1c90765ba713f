#include "properties/engine/diagnosing.hpp"

#include <tbb/parallel_for.h>

#include <deque>
#include <iterator>
#include <map>

#include "properties/engine/consultation.hpp"
#include "properties/engine/kind.hpp"

namespace rayproof {
namespace {

bool can_be_diagnosed(const Finding& finding) {
  return finding.property->claim != Claim::answers && !finding.subject->is_given_up();
}

/// Whether a boundary's finding says no more than that it is one.
bool is_vague(const Finding& finding) {
  return finding.property->claim == Claim::exact && (finding.cause == nullptr || is_avoided(finding));
}

void adopt(Finding& finding, const Finding& from) {
  finding.cause = from.cause;
  finding.kind_of_fault = from.kind_of_fault;
  finding.is_beyond_rounding = from.is_beyond_rounding;
  finding.diagnosis = from.diagnosis;
}

/// The groups of each complaint: those of a program all together, those of our own methods one after the
/// other, since of what is declared broken the cause is known.
std::vector<std::vector<Diagnosis>> groups_of(const Subject& subject,
                                              const std::vector<const Complaint*>& complaints) {
  if (!subject.has_own_contract) return diagnose_together(complaints);
  std::vector<const Hypothesis*> known;
  std::vector<std::vector<Diagnosis>> all;
  for (const Complaint* one : complaints) {
    all.push_back(diagnose(one->patient, one->failing, one->passing, known));
    for (const Diagnosis& group : all.back())
      if (group.cause != nullptr && std::ranges::find(known, group.cause) == known.end())
        known.push_back(group.cause);
  }
  return all;
}

/// Every cause that the groups name, once.
std::vector<const Hypothesis*> causes_in(const std::vector<std::vector<Diagnosis>>& groups) {
  std::vector<const Hypothesis*> causes;
  for (const std::vector<Diagnosis>& some : groups)
    for (const Diagnosis& group : some)
      if (group.cause != nullptr && std::ranges::find(causes, group.cause) == causes.end())
        causes.push_back(group.cause);
  return causes;
}

/// The faults of a program that those known hide.
std::vector<Finding> hidden(std::deque<diagnosis::Consultation>& consultations,
                            const std::vector<const Hypothesis*>& known) {
  std::vector<diagnosis::Consultation*> asked;
  std::vector<const Complaint*> complaints;
  for (diagnosis::Consultation& one : consultations)
    if (one.turn_to_rest(known)) {
      asked.push_back(&one);
      complaints.push_back(&one.complaint());
    }
  std::vector<Finding> found;
  if (complaints.empty()) return found;
  const auto groups = diagnose_together(complaints);
  for (std::size_t k = 0; k < asked.size(); ++k)
    std::ranges::move(asked[k]->findings_of_rest(groups[k], known), std::back_inserter(found));
  return found;
}

/// Diagnoses these findings of one subject, and returns the others that it deserves.
std::vector<Finding> diagnosed(const RunResult& result, const std::vector<Finding*>& findings,
                               const Samples& samples, const std::atomic<bool>& stop) {
  std::deque<diagnosis::Consultation> consultations;
  std::vector<const Complaint*> complaints;
  for (Finding* finding : findings) {
    if (stop) return {};
    complaints.push_back(&consultations.emplace_back(result, samples, *finding, stop).complaint());
  }
  if (findings.empty()) return {};
  const auto groups = groups_of(*findings.front()->subject, complaints);
  std::vector<Finding> others;
  for (std::size_t k = 0; k < findings.size(); ++k)
    std::ranges::move(consultations[k].findings(groups[k]), std::back_inserter(others));
  if (!findings.front()->subject->has_own_contract)
    std::ranges::move(hidden(consultations, causes_in(groups)), std::back_inserter(others));
  return others;
}

/// All findings of one subject, those of its symmetries last: they are broken by what is wrong with its
/// answers themselves, where that is known.
std::vector<Finding> diagnose_subject(RunResult& result, const std::vector<std::size_t>& of_subject,
                                      const Samples& samples, const std::atomic<bool>& stop) {
  std::vector<Finding*> direct, symmetries;
  for (const std::size_t i : of_subject)
    if (Finding& finding = result.findings[i]; can_be_diagnosed(finding))
      (breaks_symmetry(finding) ? symmetries : direct).push_back(&finding);
  std::vector<Finding> others = diagnosed(result, direct, samples, stop);
  const Finding* first = nullptr;
  for (Finding* finding : direct) {
    if (first != nullptr && is_vague(*finding)) adopt(*finding, *first);
    const bool is_worse = first == nullptr || finding->cases > first->cases;
    if (finding->cause != nullptr && is_worse) first = finding;
  }
  if (first == nullptr) {
    std::ranges::move(diagnosed(result, symmetries, samples, stop), std::back_inserter(others));
    return others;
  }
  for (Finding* finding : symmetries) {
    adopt(*finding, *first);
    finding->cases = diagnosis::broken_cases(result, *finding);
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
