#include "properties/engine/diagnosing.hpp"

#include <tbb/parallel_for.h>

#include <cmath>
#include <iterator>
#include <map>

#include "case/writer.hpp"
#include "properties/diagnosis/diagnose.hpp"
#include "properties/diagnosis/patient.hpp"
#include "properties/shrink/shrink.hpp"

namespace rayproof {
namespace {

constexpr std::size_t most_failing = 64, most_passing = 96;
/// What is declared has been diagnosed by its author: a few cases are enough.
constexpr std::size_t most_declared = 24;

/// How many cases of the run broke the finding's property.
std::uint64_t broken_cases(const RunResult& result, const Finding& finding) {
  std::uint64_t sum = 0;
  const auto p = static_cast<std::size_t>(finding.property - properties().data());
  for (const Unit& unit : result.units)
    if (unit.subject == finding.subject && unit.precision == finding.one.precision &&
        p < unit.tally.properties.size())
      sum += unit.tally.properties[p].broken;
  return std::max<std::uint64_t>(sum, 1);
}

/// One finding, and what its diagnosis makes of it.
class Consultation {
 public:
  Consultation(const RunResult& result, const Samples& samples, Finding& finding,
               const std::atomic<bool>& stop)
      : finding_(finding),
        stop_(stop),
        patient_(patient_of(*finding.subject, *finding.property)),
        broken_(broken_cases(result, finding)) {
    const bool is_declared = finding.is_declared;
    const Samples::KeptCases* sample =
        samples.find(*finding.subject, finding.one.precision, *finding.property);
    if (sample != nullptr) {
      failing_ = in_turn(sample->broken, is_declared ? most_declared : most_failing);
      passing_ = in_turn(sample->held, is_declared ? most_declared : most_passing);
    }
    add_right_answers(samples);
    if (failing_.empty()) failing_.push_back(finding.one);
  }

  /// Completes the finding; the others that its property deserves. Causes that are `known` of the subject are
  /// tried first, and new ones added.
  std::vector<Finding> findings(std::vector<const Hypothesis*>& known) {
    const std::vector<Diagnosis> groups = diagnose(patient_, failing_, passing_, known);
    for (const Diagnosis& group : groups)
      if (group.cause != nullptr && std::ranges::find(known, group.cause) == known.end())
        known.push_back(group.cause);
    const Diagnosis& own = own_group(groups);
    describe(finding_, own);
    std::vector<Finding> others;
    for (const Diagnosis& group : groups) {
      if (&group == &own || finding_.is_declared || stop_) continue;
      others.push_back(of_group(group));
    }
    return others;
  }

 private:
  /// A property may be kept on few cases, or those of one kind; a model must not contradict what the subject
  /// says rightly of any.
  void add_right_answers(const Samples& samples) {
    const Samples::KeptCases* any =
        samples.find(*finding_.subject, finding_.one.precision, *find_property("ascending"));
    if (any == nullptr) return;
    for (Case& one : in_turn(any->held, finding_.is_declared ? most_declared : most_passing))
      if (is_ordinary(one)) passing_.push_back(std::move(one));
  }

  /// Whether the subject promises anything of the case: beyond that models may overflow as it does.
  [[nodiscard]] bool is_ordinary(const Case& one) const {
    return finding_.subject->function == nullptr || Trial(*finding_.subject, one).in_domain();
  }

  /// The group whose cause explains the finding's own case; the largest where none does.
  const Diagnosis& own_group(const std::vector<Diagnosis>& groups) const {
    for (const Diagnosis& group : groups)
      if (group.cause != nullptr && explains(patient_, *group.cause, finding_.one)) return group;
    return *std::ranges::max_element(groups, {}, [](const Diagnosis& one) { return one.cases.size(); });
  }

  void describe(Finding& finding, const Diagnosis& group) const {
    finding.cause = group.cause;
    finding.kind_of_fault = group.cause == nullptr ? std::nullopt : std::optional(group.kind);
    finding.diagnosis = group.sentence;
    const double share = static_cast<double>(group.cases.size()) / static_cast<double>(failing_.size());
    finding.cases = std::max<std::uint64_t>(1, std::llround(share * static_cast<double>(broken_)));
    finding.striking = most_striking(group);
  }

  /// The case of the group that breaks the property worst; nothing where there is only yes and no.
  [[nodiscard]] std::optional<Case> most_striking(const Diagnosis& group) const {
    std::optional<Case> worst;
    double most = 0;
    if (finding_.property->excess == nullptr || finding_.subject->function == nullptr) return worst;
    for (const std::size_t i : group.cases) {
      Trial trial(*finding_.subject, failing_[i]);
      const double excess = finding_.property->excess(trial);
      if (!(excess > most)) continue;
      most = excess;
      worst = failing_[i];
    }
    return worst;
  }

  /// A finding of its own for a group, its simplest case made simpler.
  [[nodiscard]] Finding of_group(const Diagnosis& group) const {
    Finding other = finding_;
    const auto simplest =
        std::ranges::min(group.cases, {}, [&](std::size_t i) { return complexity(failing_[i]); });
    other.one = shrink(failing_[simplest], [&](const Case& one) { return is_of(group, one); },
                       {.tries = 3000, .time = std::chrono::milliseconds(1500), .stop = &stop_});
    Trial shrunk(*other.subject, other.one);
    other.evidence = other.property->show(shrunk);
    describe(other, group);
    return other;
  }

  [[nodiscard]] bool is_of(const Diagnosis& group, const Case& one) const {
    const auto answer = patient_.ask({&one, 1}).front();
    if (!answer || patient_.rule(one, *answer) != Ruling::broken) return false;
    return group.cause == nullptr || explains(patient_, *group.cause, one);
  }

  Finding& finding_;
  const std::atomic<bool>& stop_;
  Patient patient_;
  std::uint64_t broken_;
  std::vector<Case> failing_{};
  std::vector<Case> passing_{};
};

bool can_be_diagnosed(const Finding& finding) {
  return finding.property->claim != Claim::answers && !finding.subject->is_given_up();
}

bool is_of_symmetry(const Finding& finding) {
  const Claim claim = finding.property->claim;
  return claim == Claim::scaled || claim == Claim::reversed || claim == Claim::moved;
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
      if (stop || !can_be_diagnosed(finding) || is_of_symmetry(finding) != are_symmetries) continue;
      if (are_symmetries && first != nullptr) {
        adopt(finding, *first);
        finding.cases = broken_cases(result, finding);
        continue;
      }
      std::vector<Finding> more = Consultation(result, samples, finding, stop).findings(known);
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
