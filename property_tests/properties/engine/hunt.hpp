#pragma once
/// \file
/// One subject against one family under rapidcheck.

#include <atomic>
#include <functional>
#include <set>

#include "generators/generators.hpp"
#include "properties/engine/judged.hpp"
#include "properties/engine/samples.hpp"
#include "properties/engine/tally.hpp"

namespace rayproof {

/// A subject on a family at one precision, what is asked of it there, and what has come of it so far.
struct Unit {
  const Subject* subject = nullptr;
  const Family* family = nullptr;
  Precision precision{};
  std::vector<std::size_t> tested{};  ///< the numbers in properties() of what is tested on the cases
  bool measure = true;                ///< take the worst errors, too
  Tally tally{};
  /// On how many of the other cases that properties ask a guest has failed: after some, it is asked none.
  std::atomic<unsigned>* others_failed = nullptr;
  /// What has been judged of other subjects' answers to the same cases; null where nothing is kept.
  JudgedBlocks* judged = nullptr;
};

/// rapidcheck draws a seed for this many cases at a time: its own cost for each draw would outweigh a cheap
/// case's.
inline constexpr unsigned cases_in_block = 16384;

/// The seed of the first block of cases of a family: its case k, below `cases_in_block`, is the one that
/// combine(this, k) stands for. Every run with this seed begins with these.
[[nodiscard]] std::uint64_t seed_of_first_block(const Family& family, Precision precision,
                                                std::uint64_t seed);

/// The same of the first `blocks` blocks, as long as no property breaks, of a run of `rayproof check` with
/// that seed and without a time limit.
[[nodiscard]] std::vector<std::uint64_t> seeds_of_blocks(const Family& family, Precision precision,
                                                         std::uint64_t seed_of_run, std::uint64_t blocks);

/// A rapidcheck test of one unit. Where a case breaks a property for the first time, the test fails there,
/// the case is handed to `found`, and the test goes on behind it with that property known to be broken.
///
/// Not to be run on two threads at once: rapidcheck keeps global state. Each block of cases uses all threads
/// of the current arena; the outcome does not depend on their number.
struct Hunt {
  Unit& unit;
  std::set<std::size_t>& already_broken;
  const std::atomic<bool>& stop;
  std::uint64_t seed = 0;
  std::uint64_t cases = 0;
  std::function<void(double)> progress{};  ///< the share of the cases that is done
  /// With what came of asking a program; null of a function.
  std::function<void(std::size_t property, const Case& one, const Outcome* outcome)> found{};

  /// For each property, the first cases of a block that broke it and that kept it.
  std::function<void(std::size_t property, std::uint64_t block_seed, const BlockSample& sample)> sampled =
      [](std::size_t, std::uint64_t, const BlockSample&) {};

  void run();
};

}  // namespace rayproof
