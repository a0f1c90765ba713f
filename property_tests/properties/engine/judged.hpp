#pragma once
/// \file
/// Judgements of blocks of cases, kept for the subjects that are given the same.

#include <cstdint>
#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "oracle/judged_answers.hpp"

namespace rayproof {

/// What has been judged of the cases of the last few blocks that any subject was given.
class JudgedBlocks {
 public:
  /// An entry for each case of a block, to be used by one thread at a time; valid until the next call.
  [[nodiscard]] std::span<oracle::JudgedAnswers> block(std::uint64_t block_seed, unsigned cases);

 private:
  static constexpr std::size_t most_blocks = 4;  // of about 10 MB

  std::deque<std::pair<std::uint64_t, std::vector<oracle::JudgedAnswers>>> blocks_{};
};

}  // namespace rayproof
