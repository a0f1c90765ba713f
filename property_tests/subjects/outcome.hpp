#pragma once
/// \file
/// Who answers cases, and what may come of asking.

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "case/answer.hpp"
#include "case/case.hpp"

namespace rayproof {

/// What kind of outcome it is.
enum class OutcomeKind {
  answered,
  unsupported,  ///< the case is not for this subject, which says so: counted, never judged
  refused,      ///< it gave up on a valid case
  crashed,
  timed_out,
  nonsense,  ///< what came back is no answer to the case
  not_asked  ///< it has failed too often to be asked more
};

/// What came of asking a subject one case.
struct Outcome {
  OutcomeKind kind = OutcomeKind::answered;
  Answer answer{};         ///< where answered
  std::string sentence{};  ///< where not: what happened, in one sentence

  [[nodiscard]] bool is_answered() const { return kind == OutcomeKind::answered; }
  /// Whether a valid case should have got an answer, and did not.
  [[nodiscard]] bool is_failure() const {
    return OutcomeKind::refused <= kind && kind <= OutcomeKind::nonsense;
  }
};

/// The name of a kind, as findings have it.
[[nodiscard]] constexpr std::string_view name_of(OutcomeKind kind) {
  constexpr std::array<std::string_view, 7> names{"answered",  "unsupported", "refused",  "crashed",
                                                  "timed out", "nonsense",    "not asked"};
  return names.at(static_cast<std::size_t>(kind));
}

/// Answers cases; one instance for each worker thread, never shared.
class Answerer {
 public:
  Answerer() = default;
  Answerer(const Answerer&) = delete;
  Answerer& operator=(const Answerer&) = delete;
  virtual ~Answerer() = default;

  /// Puts what comes of asking `cases[i]` into `outcomes[i]`, of which there are as many.
  virtual void answer(std::span<const Case> cases, std::span<Outcome> outcomes) = 0;

  /// Forgets all that it was asked: a program is started anew with the next case.
  virtual void forget() {}

  /// One case alone.
  [[nodiscard]] Outcome answer(const Case& one) {
    Outcome outcome;
    answer({&one, 1}, {&outcome, 1});
    return outcome;
  }
};

/// A function that answers any case at once.
class FunctionAnswerer final : public Answerer {
 public:
  explicit FunctionAnswerer(Answer (*function)(const Case&)) : function_(function) {}

  void answer(std::span<const Case> cases, std::span<Outcome> outcomes) override {
    for (std::size_t i = 0; i < cases.size(); ++i) outcomes[i].answer = function_(cases[i]);
  }

 private:
  Answer (*function_)(const Case&);
};

}  // namespace rayproof
