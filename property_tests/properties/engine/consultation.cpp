#include "properties/engine/consultation.hpp"

#include <cmath>
#include <iterator>

#include "properties/diagnosis/cures/cures.hpp"
#include "properties/shrink/shrink.hpp"

namespace rayproof::diagnosis {
namespace {

constexpr std::size_t most_failing = 64, most_passing = 96;
/// What is declared has been diagnosed by its author: a few cases are enough.
constexpr std::size_t most_declared = 24;

}  // namespace

std::uint64_t broken_cases(const RunResult& result, const Finding& finding) {
  std::uint64_t sum = 0;
  const auto p = static_cast<std::size_t>(finding.property - properties().data());
  for (const Unit& unit : result.units)
    if (unit.subject == finding.subject && unit.precision == finding.one.precision &&
        p < unit.tally.properties.size())
      sum += unit.tally.properties[p].broken;
  return std::max<std::uint64_t>(sum, 1);
}

Consultation::Consultation(const RunResult& result, const Samples& samples, Finding& finding,
                           const std::atomic<bool>& stop)
    : finding_(finding),
      stop_(stop),
      sample_(samples.find(*finding.subject, finding.one.precision, *finding.property)),
      complaint_{.patient = patient_of(*finding.subject, *finding.property)},
      broken_(broken_cases(result, finding)) {
  const bool is_declared = finding.is_declared;
  complaint_.broken = static_cast<double>(broken_);
  if (sample_ != nullptr) {
    complaint_.failing = in_turn(sample_->broken, is_declared ? most_declared : most_failing);
    complaint_.passing = in_turn(sample_->held, is_declared ? most_declared : most_passing);
  }
  add_right_answers(samples);
  if (complaint_.failing.empty()) complaint_.failing.push_back(finding.one);
  if (is_declared || finding.subject->has_own_contract) return;
  add_neighbours();
  add_simple_twins();
}

std::vector<Finding> Consultation::findings(const std::vector<Diagnosis>& groups) {
  const Diagnosis& own = own_group(groups);
  describe(finding_, of_its_size(own, finding_.one));
  std::vector<Finding> others;
  if (is_of_wrong_plane(own)) {
    finding_.cause = nullptr;
    return others;
  }
  for (const Diagnosis& group : groups) {
    if (&group == &own || finding_.is_declared || stop_) continue;
    if (auto other = of_group(group)) others.push_back(std::move(*other));
  }
  return others;
}

/// A property may be kept on few cases, or those of one kind; a model must not contradict what the subject
/// says rightly of any.
void Consultation::add_right_answers(const Samples& samples) {
  const Samples::PropertySample* any =
      samples.find(*finding_.subject, finding_.one.precision, *find_property("ascending"));
  if (any == nullptr) return;
  for (Case& one : in_turn(any->held, finding_.is_declared ? most_declared : most_passing))
    if (is_ordinary(one)) complaint_.passing.push_back(std::move(one));
}

/// Cases like the few that fail, with other numbers: a model must not fit a single one by chance, nor
/// contradict those that are right.
void Consultation::add_neighbours() {
  constexpr std::size_t few = 16, tries = 64;
  const std::size_t found = complaint_.failing.size();
  if (found >= few) return;
  std::vector<Case> near;
  for (std::size_t k = 0; k < tries; ++k)
    std::ranges::move(varied(complaint_.failing[k % found], k), std::back_inserter(near));
  const std::vector<std::optional<Answer>> answers = complaint_.patient.ask(near);
  for (std::size_t k = 0; k < near.size() && complaint_.failing.size() < few; ++k) {
    if (!answers[k]) continue;
    const Ruling ruling = complaint_.patient.rule(near[k], *answers[k]);
    if (ruling == Ruling::outside) continue;
    (ruling == Ruling::broken ? complaint_.failing : complaint_.passing).push_back(std::move(near[k]));
  }
}

/// What fails, with fewer digits, as far as it is right then: a model of more than rounding must not
/// contradict that.
void Consultation::add_simple_twins() {
  constexpr std::size_t few = 24;
  const Change simplify = find_hypothesis("few-digits")->change;
  std::vector<Case> twins;
  for (std::size_t k = 0; k < std::min(few, complaint_.failing.size()); ++k)
    std::ranges::move(simplify(complaint_.failing[k]), std::back_inserter(twins));
  const std::vector<std::optional<Answer>> answers = complaint_.patient.ask(twins);
  for (std::size_t k = 0; k < twins.size(); ++k)
    if (answers[k] && complaint_.patient.rule(twins[k], *answers[k]) != Ruling::broken)
      complaint_.passing.push_back(std::move(twins[k]));
}

/// Whether the subject promises anything of the case: beyond that models may overflow as it does.
bool Consultation::is_ordinary(const Case& one) const {
  return finding_.subject->function == nullptr || Trial(*finding_.subject, one).in_domain();
}

/// Whether what is said of a plane's misses is wrong in more ways than the cause says: it follows from what
/// is computed of the plane, and so do its faults.
bool Consultation::is_of_wrong_plane(const Diagnosis& own) const {
  if (finding_.property->claim != Claim::contact || topic_of(finding_.one) != "plane" || own.cause == nullptr)
    return false;
  const auto is_explained = [&](const Case& one) { return explains(complaint_.patient, *own.cause, one); };
  return !is_explained(finding_.one) || !std::ranges::all_of(complaint_.failing, is_explained);
}

/// The group whose cause explains the finding's own case; the largest where none does.
const Diagnosis& Consultation::own_group(const std::vector<Diagnosis>& groups) const {
  for (const Diagnosis& group : groups)
    if (group.cause != nullptr && explains(complaint_.patient, *group.cause, finding_.one)) return group;
  return *std::ranges::max_element(groups, {}, [](const Diagnosis& one) { return one.cases.size(); });
}

void Consultation::describe(Finding& finding, const Diagnosis& group) const {
  finding.cause = group.cause;
  finding.kind_of_fault = group.cause == nullptr ? std::nullopt : std::optional(group.kind);
  finding.is_beyond_rounding = group.is_beyond_rounding;
  finding.diagnosis = group.sentence;
  const double share =
      static_cast<double>(group.cases.size()) / static_cast<double>(complaint_.failing.size());
  finding.cases = std::max(std::uint64_t{1},
                           static_cast<std::uint64_t>(std::llround(share * static_cast<double>(broken_))));
  finding.striking = most_striking(group);
}

/// The case of the group that breaks the property worst; nothing where there is only yes and no.
std::optional<Case> Consultation::most_striking(const Diagnosis& group) const {
  std::optional<Case> worst;
  double most = 0;
  if (finding_.property->excess == nullptr) return worst;
  std::vector<Case> cases;
  for (const std::size_t i : group.cases) cases.push_back(complaint_.failing[i]);
  const std::vector<std::optional<Answer>> answers = complaint_.patient.ask(cases);
  for (std::size_t k = 0; k < cases.size(); ++k) {
    if (!answers[k] || complaint_.patient.rule(cases[k], *answers[k]) != Ruling::broken) continue;
    Trial trial(*finding_.subject, cases[k]);
    trial.know({.answer = *answers[k]}, {});
    const double excess = finding_.property->excess(trial);
    if (!(excess > most)) continue;
    most = excess;
    worst = cases[k];
  }
  return worst;
}

/// A finding of its own for a group, its simplest case made simpler.
std::optional<Finding> Consultation::of_group(const Diagnosis& group) const {
  Finding other = finding_;
  const auto is_plain = [&](std::size_t i) { return shows_plainly(*other.property, complaint_.failing[i]); };
  const auto simplest = std::ranges::min(group.cases, {}, [&](std::size_t i) {
    return std::pair(!is_plain(i), complexity(complaint_.failing[i]));
  });
  const auto first = [&, is_plain = is_plain(simplest)](std::span<const Case> cases) {
    return first_of(group, cases, is_plain);
  };
  other.one = shrink(complaint_.failing[simplest], {.first = first, .at_once = asked_at_once(*other.subject)},
                     {.tries = 3000, .time = std::chrono::milliseconds(1500), .stop = &stop_});
  Trial shrunk(*other.subject, other.one);
  if (ruling_of(*other.property, shrunk) != Ruling::broken) return std::nullopt;  // a program's mood
  other.evidence = other.property->show(shrunk);
  describe(other, of_its_size(group, other.one));
  return other;
}

std::optional<std::size_t> Consultation::first_of(const Diagnosis& group, std::span<const Case> cases,
                                                  bool is_plain) const {
  if (group.cause != nullptr && group.cause->asked != Asking::in_turn)
    return std::nullopt;  // nor is a simpler one
  const std::vector<std::optional<Answer>> answers = complaint_.patient.ask(cases);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!answers[i] || complaint_.patient.rule(cases[i], *answers[i]) != Ruling::broken) continue;
    if (is_plain && !shows_plainly(*finding_.property, cases[i])) continue;
    if (group.cause == nullptr || explains(complaint_.patient, *group.cause, cases[i])) return i;
  }
  return std::nullopt;
}

}  // namespace rayproof::diagnosis
