#pragma once
/// \file
/// A program as one worker thread asks it.

#include <memory>

#include "subjects/outcome.hpp"
#include "subjects/program/conversation.hpp"

namespace rayproof::program {

/// Asks many cases at once. Where something goes wrong, the case that is to blame is searched for by starting
/// the program again and asking one by one what has no answer; then the rest is asked at once again.
class ProgramAnswerer final : public Answerer {
 public:
  explicit ProgramAnswerer(std::shared_ptr<Program> program) : program_(std::move(program)) {}

  /// Throws CannotStart.
  void answer(std::span<const Case> cases, std::span<Outcome> outcomes) override;
  void forget() override { conversation_.reset(); }

 private:
  [[nodiscard]] Conversation& conversation();
  /// Asks what has no answer, all at once. Whether every case then has one, or no more is to be asked now.
  bool ask_rest(Round& all);
  /// Finds whom to blame for such an end, and puts that down as its outcome; nobody where each case alone is
  /// answered and the silence may have been the machine's.
  void search(Round& all, Conversation::RoundEnd ending, const std::string& trouble, bool is_machines);
  /// Whether silence means that answers are held back until the input is closed; then it is given up.
  bool holds_back(Round& rest);
  [[nodiscard]] bool ask_alone(Round& all, std::size_t i);

  std::shared_ptr<Program> program_;
  std::unique_ptr<Conversation> conversation_{};
};

}  // namespace rayproof::program
