#pragma once
/// \file
/// Two reports beside each other: what got worse.

#include <vector>

#include "bench/figures/row.hpp"

namespace rayproof::report {

/// One row in both reports; the pointers are into these.
struct Change {
  const BenchRow* before = nullptr;
  const BenchRow* now = nullptr;
  double slowdown = 1;  ///< how many times as long it takes, the ratio of the machines taken out
};

/// A report beside an older one, or beside that of another machine.
struct ReportComparison {
  std::size_t rows = 0;   ///< how many both have
  double machines = 1;    ///< how many times as long a row takes now; the median
  std::size_t other = 0;  ///< rows of other cases than before (another --rays): their errors say nothing
  std::vector<Change> wronger{};  ///< more wrong verdicts than before, or more ulps, on the same cases
  std::vector<Change> slower{};   ///< by a fifth, and by more than the passes spread; the slowest first
  std::vector<Change> faster{};   ///< the other way round; the fastest first
};

/// Both have to outlive what is returned.
[[nodiscard]] ReportComparison compare(const Measurements& before, const Measurements& now);

}  // namespace rayproof::report
