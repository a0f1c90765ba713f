#pragma once
/// \file
/// Judgements kept for the methods that answer a case alike: most do, and a judgement costs more than an
/// answer.

#include <cstdint>
#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "oracle/oracle.hpp"

namespace rayproof {

/// What the oracle has said of the answers to one case.
class JudgedAnswers {
 public:
  /// Null where no such answer has been judged.
  [[nodiscard]] const oracle::Judgement* find(const Answer& claimed) const;
  void add(const Answer& claimed, const oracle::Judgement& judgement) {
    judged_.emplace_back(claimed, judgement);
  }

 private:
  std::vector<std::pair<Answer, oracle::Judgement>> judged_{};
};

/// The same of the cases of the last few blocks that any subject was given.
class JudgedBlocks {
 public:
  /// An entry for each case of a block, to be used by one thread at a time; valid until the next call.
  [[nodiscard]] std::span<JudgedAnswers> block(std::uint64_t block_seed, unsigned cases);

 private:
  static constexpr std::size_t most_blocks = 4;  // of about 10 MB

  std::deque<std::pair<std::uint64_t, std::vector<JudgedAnswers>>> blocks_{};
};

}  // namespace rayproof
