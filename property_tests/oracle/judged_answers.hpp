#pragma once
/// \file
/// Judgements kept for the methods that answer a case alike: most do, and a judgement costs more than an
/// answer.

#include <utility>
#include <vector>

#include "oracle/oracle.hpp"

namespace rayproof::oracle {

/// What has been judged of answers to one case. Not for two threads at once.
class JudgedAnswers {
 public:
  /// What `judge` says of an answer to the case; of one that is known, without asking it again.
  [[nodiscard]] Judgement judge(const Case& one, const Answer& claimed);

  /// Null where no such answer has been judged.
  [[nodiscard]] const Judgement* find(const Answer& claimed) const;
  void add(const Answer& claimed, const Judgement& judgement) { judged_.emplace_back(claimed, judgement); }

 private:
  std::vector<std::pair<Answer, Judgement>> judged_{};
};

}  // namespace rayproof::oracle
