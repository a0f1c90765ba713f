#pragma once
/// \file
/// One subject against one family under rapidcheck.

#include <atomic>
#include <functional>
#include <set>

#include "properties/block.hpp"

namespace rayproof {

/// rapidcheck draws a seed for so many cases at a time: its own cost for each draw would outweigh a cheap
/// case's.
inline constexpr unsigned cases_in_block = 16384;

/// A rapidcheck test of one subject on one family. Where a case breaks a property for the first time, the
/// test fails there, the case is handed to `found`, and the test goes on behind it with that property known
/// to be broken.
///
/// Not to be run on two threads at once: rapidcheck keeps global state. The blocks inside use all threads.
struct Hunt {
  const Subject& subject;
  const Family& family;
  Precision precision{};
  std::vector<bool> active{};  ///< for each of properties()
  std::set<std::size_t> already_broken{};
  bool measure = false;  ///< even where no active property needs the judgement
  std::uint64_t seed = 0;
  std::uint64_t cases = 0;
  const std::atomic<bool>* stop = nullptr;
  std::function<void(double)> progress{};  ///< the share of the cases that is done
  std::function<void(std::size_t property, const Case& one)> found{};

  [[nodiscard]] Tally run();
};

}  // namespace rayproof
