#include "subjects/program/conversation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "case/shape_format.hpp"
#include "case/writer.hpp"

namespace rayproof::program {

using std::chrono::milliseconds;

namespace {

/// So long at most nobody looks whether the program is to be asked no more.
constexpr milliseconds a_while{100};
/// No answer is longer, and no program may fill the memory.
constexpr std::size_t longest_line = std::size_t{1} << 26U;

}  // namespace

void Round::put(std::size_t i, Outcome outcome) {
  if (!has_answer[i]) --waiting;
  has_answer[i] = true;
  outcomes[i] = std::move(outcome);
}

void Round::take_back(std::size_t i) {
  if (has_answer[i]) ++waiting;
  has_answer[i] = false;
}

void Conversation::write(const Round& round) {
  first_id_ = program_->next_ids(round.cases.size());
  for (std::size_t i = 0; i < round.cases.size(); ++i) {
    const fmt::format_int id(first_id_ + i);
    unsent_.append("{\"id\": ").append(id.data(), id.size()).append(", ");
    const Case& one = round.cases[i];
    if (one.id.empty() && one.note.empty()) {
      unsent_.append(write_case_for_doubles(one), 1);  // without its opening bracket
    } else {
      Case bare = one;
      bare.id.clear();
      bare.note.clear();
      unsent_.append(write_case_for_doubles(bare), 1);
    }
    unsent_ += '\n';
  }
}

Conversation::RoundEnd Conversation::ask(Round& round) {
  write(round);
  Silence silence{.last = Clock::now(), .starvation = Starvation(child_.group())};
  while (round.waiting > 0) {
    if (program_->is_stopped() || is_too_long(silence)) return RoundEnd::silence;
    const std::size_t waiting = round.waiting;
    child_.exchange(unsent_, received_, a_while);
    if (!take_lines(round)) return RoundEnd::nonsense;
    if (round.waiting < waiting) silence.lasted = {};
    if (round.waiting > 0 && child_.is_output_closed())
      return take_line(round, received_) && round.waiting == 0 ? RoundEnd::complete : RoundEnd::closed;
  }
  return goes_on(round) ? RoundEnd::nonsense : RoundEnd::complete;
}

/// A program that loads much before its first answer has its time; one that only sleeps has no more than any.
bool Conversation::is_too_long(Silence& silence) {
  const Clock::time_point now = Clock::now();
  silence.lasted += std::min<Clock::duration>(now - std::exchange(silence.last, now), 2 * a_while);
  if (silence.lasted <= program_->patience_of_case()) return false;
  if (!has_spoken_ && silence.lasted <= program_->first_case_time()) {
    if (now - silence.looked < milliseconds(500)) return false;
    silence.looked = now;
    silence.idle = silence.starvation.is_idle() ? silence.idle + 1 : 0;
    return silence.idle > 2;
  }
  is_silent_itself_ = !silence.starvation.goes_on();
  if (is_silent_itself_ || silence.patience-- == 0) return true;
  silence.lasted = {};
  return false;
}

bool Conversation::goes_on(Round& round) {
  if (child_.is_output_closed()) return false;
  child_.exchange(unsent_, received_, milliseconds(program_->repeats() ? 20 : 0));
  return !take_lines(round);
}

bool Conversation::answers_at_the_end(Round& round) {
  child_.close_input();
  const Clock::time_point end = Clock::now() + milliseconds(1500);
  while (round.waiting > 0 && !child_.is_output_closed() && Clock::now() < end) {
    child_.exchange(unsent_, received_, milliseconds(100));
    if (!take_lines(round)) return false;
  }
  return round.waiting == 0;
}

bool Conversation::take_lines(Round& round) {
  std::size_t begin = 0;
  bool is_well = true;
  // What was searched before has no end of a line.
  for (std::size_t end = received_.find('\n', searched_); is_well && end != std::string::npos;
       end = received_.find('\n', begin)) {
    is_well = take_line(round, std::string_view(received_).substr(begin, end - begin));
    begin = end + 1;
  }
  received_.erase(0, begin);
  searched_ = is_well ? received_.size() : 0;
  if (is_well && received_.size() > longest_line) {
    stray_ = fmt::format("wrote {} bytes without the end of a line", received_.size());
    return false;
  }
  return is_well;
}

bool Conversation::take_line(Round& round, std::string_view line) {
  if (line.find_first_not_of(" \t\r") == std::string_view::npos) return true;
  const auto refuse = [&](const std::string& what) {
    stray_ = fmt::format("{}; the line is {}", what, excerpt(line));
    return false;
  };
  try {
    const ReplyLine reply(line);
    const auto id = reply.id();
    if (!id) return refuse("wrote a line without the id of a case");
    const std::uint64_t i = *id - first_id_;
    if (*id > 0 && *id < first_id_) {
      program_->note_repeat();
      return refuse("answered a case that was answered before");
    }
    if (i >= round.cases.size()) return refuse("wrote an id that no case has");
    if (round.has_answer[i]) {
      program_->note_repeat();
      if (round.cases.size() > 1) {  // which of them is to blame is found by asking one by one
        round.take_back(i);
        return refuse("answered a case twice");
      }
      round.outcomes[i] = {
          .kind = OutcomeKind::nonsense,
          .sentence = fmt::format("answered the case twice; the second line is {}", excerpt(line))};
      return true;
    }
    if (!has_spoken_) program_->note_start(Clock::now() - start_);
    has_spoken_ = true;
    program_->note_answers(1);
    round.put(i, reply.outcome(round.cases[i]));
    return true;
  } catch (const Refusal& why) {
    const std::string what = fmt::format("wrote a line that is no answer: {}", why.what());
    return put_nonsense(round, line, what) || refuse(what);
  }
}

/// A line that is no JSON may still say whose it is, as one with a NaN does: then nobody need be asked again.
bool Conversation::put_nonsense(Round& round, std::string_view line, const std::string& what) {
  const std::optional<std::uint64_t> id = id_in_text(line);
  const std::uint64_t i = id.value_or(0) - first_id_;
  if (!id || i >= round.cases.size() || round.has_answer[i]) return false;
  has_spoken_ = true;
  program_->note_answers(1);
  round.put(
      i, {.kind = OutcomeKind::nonsense, .sentence = fmt::format("{}; the line is {}", what, excerpt(line))});
  return true;
}

bool Conversation::is_too_loud() {
  const std::uint64_t more = child_.error_bytes() - std::exchange(noted_errors_, child_.error_bytes());
  return !program_->may_write_errors(more);
}

std::string Conversation::trouble(RoundEnd ending) {
  std::string text = stray_;
  if (ending == RoundEnd::silence)
    text = fmt::format("gave no answer within {:g} s",
                       static_cast<double>(program_->patience_of_case().count()) / 1000);
  if (ending == RoundEnd::silence && !received_.empty())
    text += fmt::format("; it wrote {} bytes without the end of a line", received_.size());
  if (const std::string end = ending == RoundEnd::silence ? child_.how_it_ended() : ""; !end.empty())
    text += fmt::format("; it {}, and a process that it has started holds its output open", end);
  if (ending == RoundEnd::closed) {
    text = child_.how_it_ended();
    if (text.empty()) text = "closed its output";
    text += " without an answer to the case";
  }
  const std::string words = last_words();
  return words.empty() ? text : fmt::format("{}; its standard error ends in: {}", text, words);
}

bool Conversation::was_never_started() {
  (void)child_.how_it_ended();
  const auto status = child_.exit_status();
  return !has_spoken_ && (status == 127 || status == 126);
}

}  // namespace rayproof::program
