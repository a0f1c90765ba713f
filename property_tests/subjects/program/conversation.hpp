#pragma once
/// \file
/// One process of a program, and the cases that it is asked.

#include <optional>
#include <span>
#include <vector>

#include "subjects/program/child.hpp"
#include "subjects/program/program.hpp"
#include "subjects/program/reply.hpp"
#include "subjects/program/starvation.hpp"

namespace rayproof::program {

/// Some cases on their way, and what has come back so far.
struct Round {
  std::span<const Case> cases{};
  std::span<Outcome> outcomes{};
  std::vector<bool> has_answer{};
  std::size_t waiting = 0;

  Round(std::span<const Case> asked, std::span<Outcome> into)
      : cases(asked), outcomes(into), has_answer(asked.size()), waiting(asked.size()) {}

  void put(std::size_t i, Outcome outcome);
  void take_back(std::size_t i);
};

/// A process that is asked round after round, as long as nothing goes wrong.
class Conversation {
 public:
  /// How a round ends: with every answer, with silence, with the end of the output, or with a line that is no
  /// answer to any case of the round.
  enum class RoundEnd { complete, silence, closed, nonsense };

  explicit Conversation(Program& program) : program_(&program), child_(program.command()) {}

  /// Asks all cases of the round at once.
  [[nodiscard]] RoundEnd ask(Round& round);
  /// Closes the input, and whether every answer that was missing comes then.
  [[nodiscard]] bool answers_at_the_end(Round& round);

  /// Whether the silence that ended a round was the program's own, and not for want of the processor.
  [[nodiscard]] bool is_silent_itself() const { return is_silent_itself_; }

  /// What went wrong, in one sentence, with what the program said of it on standard error.
  [[nodiscard]] std::string trouble(RoundEnd ending);

  /// Whether the shell found nothing to start.
  [[nodiscard]] bool was_never_started();
  [[nodiscard]] std::string last_words() { return child_.last_words(); }
  /// Whether the program has written more to standard error than anybody reads.
  [[nodiscard]] bool is_too_loud();

 private:
  using Clock = Program::Clock;

  /// How long the program has been silent, and why.
  struct Silence {
    Clock::time_point last{};  ///< when it was last noted
    Clock::duration lasted{};  ///< without what this process slept, too
    Starvation starvation;
    int patience = 5;            ///< how often one that does not get the processor has its time once more
    Clock::time_point looked{};  ///< when it was last looked at
    int idle = 0;                ///< how often in a row it did nothing then
  };

  void write(const Round& round);
  [[nodiscard]] bool is_too_long(Silence& silence);
  /// Takes the whole lines that have come. False after one that is no answer.
  [[nodiscard]] bool take_lines(Round& round);
  [[nodiscard]] bool take_line(Round& round, std::string_view line);
  /// Whether the line, which is no answer, could be put down as that of a case.
  [[nodiscard]] bool put_nonsense(Round& round, std::string_view line, const std::string& what);
  /// Whether a second answer comes right behind the last one, from a program that has given such before.
  [[nodiscard]] bool goes_on(Round& round);

  Program* program_;
  Child child_;
  Clock::time_point start_ = Clock::now();
  bool has_spoken_ = false, is_silent_itself_ = false;
  std::uint64_t first_id_ = 0;  ///< of the round
  std::string unsent_{}, received_{};
  std::size_t searched_ = 0;        ///< the number of bytes received that hold no end of a line
  std::uint64_t noted_errors_ = 0;  ///< bytes of standard error that the program's account holds
  std::string stray_{};             ///< what is wrong with the line that is no answer
};

}  // namespace rayproof::program
