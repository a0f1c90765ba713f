#include "properties/engine/found.hpp"

#include "case/writer.hpp"
#include "properties/shrink/shrink.hpp"

namespace rayproof {

namespace {

/// Whether simpler cases can be tried: each try at a case that is never answered takes seconds.
bool can_be_shrunk(Trial& as_found) {
  const Subject& subject = as_found.subject();
  if (subject.function != nullptr) return true;
  return !subject.is_given_up() && as_found.outcome().kind != OutcomeKind::timed_out;
}

/// A program may be gone, or answer otherwise, when it is asked a second time.
bool can_be_shown(const Property& property, Trial& as_found) {
  return as_found.subject().function != nullptr || property.claim == Claim::answers ||
         as_found.outcome().is_answered();
}

/// The simplest case like the one found. What is simpler is another case: it has no id, and what is noted
/// of the first is not true of it.
Case simplest(const Case& found, const Breaking& breaking, std::chrono::milliseconds time,
              const std::atomic<bool>& stop) {
  Case bare = found;
  bare.id.clear();
  bare.note.clear();
  Case shrunk = shrink(bare, breaking, {.time = time, .stop = &stop});
  return write_case(shrunk) == write_case(bare) ? found : shrunk;
}

}  // namespace

std::optional<Finding> made_of(const BrokenCase& found, const Listener& listener,
                               const std::atomic<bool>& stop) {
  const auto& [subject, property, one, family, outcome] = found;
  Finding finding{.subject = &subject,
                  .property = &property,
                  .family = family,
                  .one = one,
                  .is_declared = is_declared_refuted(subject, property)};
  Trial as_found(subject, one);
  if (outcome != nullptr) as_found.know(*outcome, {});
  if (!can_be_shown(property, as_found)) return std::nullopt;
  finding.evidence = property.show(as_found);
  listener.broken(finding);
  if (can_be_shrunk(as_found)) {
    const bool is_crash = property.claim == Claim::answers;  // each try costs a new process
    finding.one = simplest(one, striking_break(subject, property, as_found),
                           is_crash ? std::chrono::milliseconds(1000) : ShrinkBudget{}.time, stop);
    Trial shrunk(subject, finding.one);
    if (subject.function != nullptr || ruling_of(property, shrunk) == Ruling::broken)
      finding.evidence = property.show(shrunk);
    else
      finding.one = one;
  }
  listener.finding(finding);
  return finding;
}

}  // namespace rayproof
