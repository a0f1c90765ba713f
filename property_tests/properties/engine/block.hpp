#pragma once
/// \file
/// A block of a family's cases given to a subject, by all threads.

#include <atomic>
#include <map>

#include "properties/engine/hunt.hpp"

namespace rayproof {

/// What came of a block of cases. Its k-th case is the one that combine(seed of the block, k) stands for.
struct BlockResult {
  Tally tally{};
  std::vector<BlockSample> samples{};  ///< in the order of properties()
  /// For each broken property (an index into properties()) the first case that broke it, by number.
  std::map<std::size_t, unsigned> first_broken{};
  /// Of a program: what came of asking each of those. Asked again, it may behave.
  std::map<std::size_t, Outcome> outcomes{};

  void put(const Unit& unit, Trial& trial, unsigned k);
  BlockResult& operator+=(const BlockResult& more);
};

/// The case of a block by its number.
[[nodiscard]] Case case_of(const Unit& unit, std::uint64_t block_seed, unsigned k);

/// Puts the first `cases` of a block to the unit's subject; its tally is not touched.
[[nodiscard]] BlockResult run_block(const Unit& unit, std::uint64_t block_seed, unsigned cases,
                                    const std::atomic<bool>& stop);

/// What the seeds of a family's blocks are made from. Nothing of the subject is in it: subjects are put the
/// same cases.
[[nodiscard]] std::uint64_t stream_of(const Family& family, Precision precision, std::uint64_t seed);

}  // namespace rayproof
