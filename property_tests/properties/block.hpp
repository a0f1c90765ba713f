#pragma once
/// \file
/// A block of cases put to a subject, on all threads of the current arena.

#include <map>

#include "properties/plan.hpp"
#include "properties/tally.hpp"

namespace rayproof {

/// What a block is made of. Its k-th case is the one that combine(seed, k) stands for.
struct Block {
  const Subject* subject = nullptr;
  const Family* family = nullptr;
  Precision precision{};
  std::uint64_t seed = 0;
  unsigned cases = 0;
  std::vector<bool> active{};  ///< for each of properties(): is it put to the cases?
  bool measure = true;         ///< take the worst errors, too
};

struct BlockResult {
  Tally tally{};
  /// For each broken property (an index into properties()) the first case that broke it, by number.
  std::map<std::size_t, unsigned> first_broken{};
};

/// The outcome depends on the block alone, not on the number of threads.
[[nodiscard]] BlockResult run(const Block& block);

/// The block's k-th case.
[[nodiscard]] Case case_of(const Block& block, unsigned k);

}  // namespace rayproof
