#include "subjects/program/answerer.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rayproof::program {
namespace {

using RoundEnd = Conversation::RoundEnd;

constexpr const char* held_back =
    "answers only once its input is closed: each line must be flushed as soon as it is written";

constexpr const char* too_loud = "wrote more than 1 GB to standard error, which nobody reads";

/// How many failures of one call are looked into; the cases that are left are not asked.
constexpr int most_failures = 2;

Outcome failure(RoundEnd ending, const std::string& sentence) {
  const auto kind = ending == RoundEnd::silence  ? OutcomeKind::timed_out
                    : ending == RoundEnd::closed ? OutcomeKind::crashed
                                                 : OutcomeKind::nonsense;
  return {.kind = kind, .sentence = sentence};
}

std::vector<std::size_t> waiting_in(const Round& round) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < round.cases.size(); ++i)
    if (!round.has_answer[i]) places.push_back(i);
  return places;
}

}  // namespace

Conversation& ProgramAnswerer::conversation() {
  if (!conversation_) conversation_ = std::make_unique<Conversation>(*program_);
  return *conversation_;
}

void ProgramAnswerer::answer(std::span<const Case> cases, std::span<Outcome> outcomes) {
  std::ranges::fill(outcomes, Outcome{.kind = OutcomeKind::not_asked});
  Round all(cases, outcomes);
  for (int failures = 0; failures < most_failures && !ask_rest(all); ++failures) {
  }
}

bool ProgramAnswerer::ask_rest(Round& all) {
  if (program_->was_given_up() || all.waiting == 0) return true;
  const std::vector<std::size_t> places = waiting_in(all);
  const bool is_all = places.size() == all.cases.size();
  std::vector<Case> cases;
  std::vector<Outcome> outcomes(is_all ? 0 : places.size());
  if (!is_all)
    for (const std::size_t i : places) cases.push_back(all.cases[i]);
  Round rest = is_all ? Round(all.cases, all.outcomes) : Round(cases, outcomes);
  const auto begin = Program::Clock::now();
  const RoundEnd ending = conversation().ask(rest);
  if (!is_all || ending != RoundEnd::complete)
    for (std::size_t k = 0; k < places.size(); ++k)
      if (rest.has_answer[k]) all.put(places[k], rest.outcomes[k]);
  if (ending == RoundEnd::complete) {
    program_->note_complete_round();
    if (conversation_->is_too_loud()) {
      program_->give_up(std::string("it ") + too_loud);
      all.put(places.front(), failure(RoundEnd::nonsense, too_loud));
    }
    return true;
  }
  if (program_->is_stopped()) {
    conversation_.reset();
    return true;
  }
  const std::string trouble = conversation_->trouble(ending);
  if (!program_->has_answered() && conversation_->was_never_started())
    throw CannotStart(
        fmt::format("{} cannot be started: {}", program_->command(), conversation_->last_words()));
  const bool is_held_back =
      ending == RoundEnd::silence && program_->begin_look_for_held_back() && holds_back(rest);
  const bool is_machines = ending == RoundEnd::silence && !conversation_->is_silent_itself();
  conversation_.reset();
  if (ending == RoundEnd::silence && !program_->has_answered())
    program_->give_up("it answered nothing at all");
  if (program_->was_given_up())
    all.put(places.front(), failure(ending, is_held_back ? held_back : trouble));
  else
    search(all, ending, trouble, is_machines);
  // One case alone that breaks is being shrunk; silence is too long to be overlooked even then.
  if (all.cases.size() > 1 || ending == RoundEnd::silence || !program_->has_answered())
    program_->note_trouble(1, Program::Clock::now() - begin, ending == RoundEnd::silence);
  return ending == RoundEnd::silence;  // the next would take as long
}

bool ProgramAnswerer::holds_back(Round& rest) {
  const bool has_answered_before = program_->has_answered();
  const std::vector<std::size_t> missing = waiting_in(rest);
  if (!conversation_->answers_at_the_end(rest)) return false;
  if (has_answered_before) {  // it may be late with one case alone: ask another one
    const std::size_t other = missing.front() > 0 ? 0 : missing.back();
    Outcome outcome;
    Round again(rest.cases.subspan(other, 1), {&outcome, 1});
    conversation_.reset();
    if (conversation().ask(again) != RoundEnd::silence || !conversation_->answers_at_the_end(again))
      return false;
  }
  program_->give_up(std::string("it ") + held_back);
  return true;
}

bool ProgramAnswerer::ask_alone(Round& all, std::size_t i) {
  Round single(all.cases.subspan(i, 1), all.outcomes.subspan(i, 1));
  const RoundEnd ending = conversation().ask(single);
  if (ending != RoundEnd::complete) {
    const std::string trouble = conversation_->trouble(ending);
    if (ending == RoundEnd::silence && program_->is_stopped()) return false;
    if (ending == RoundEnd::silence && program_->has_answered()) program_->note_silence();
    conversation_.reset();
    all.outcomes[i] = failure(ending, trouble);
  }
  all.put(i, all.outcomes[i]);
  return ending == RoundEnd::complete && all.outcomes[i].kind != OutcomeKind::nonsense;
}

void ProgramAnswerer::search(Round& all, RoundEnd ending, const std::string& trouble, bool is_machines) {
  // That silence is the next case's was seen once: to see it each time would take as long again.
  if (ending == RoundEnd::silence && program_->is_known_for_silence())
    return all.put(waiting_in(all).front(), failure(ending, trouble));
  // A line that belongs to nobody may have come behind the last answer: then all are asked again.
  if (all.waiting == 0)
    for (std::size_t i = 0; i < all.cases.size(); ++i) all.take_back(i);
  const std::vector<std::size_t> suspects = waiting_in(all);
  for (const std::size_t i : suspects)
    if (program_->was_given_up() || !ask_alone(all, i)) return;
  // Alone, each is answered: what went wrong needs what was asked before.
  if (!is_machines)
    all.put(suspects.front(), failure(ending, trouble + "; asked alone, it answers the case"));
}

}  // namespace rayproof::program
