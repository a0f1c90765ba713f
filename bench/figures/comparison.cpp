#include "bench/figures/comparison.hpp"

#include <algorithm>

#include "bench/figures/median.hpp"

namespace rayproof::report {

namespace {

constexpr double notable = 1.2;

void add_common(const std::vector<BenchRow>& before, const std::vector<BenchRow>& now,
                std::vector<Change>& changes) {
  for (const BenchRow& row : now) {
    const auto same = std::ranges::find_if(before, [&](const BenchRow& old) { return old.is_same_as(row); });
    if (same != before.end() && same->ns_per_ray > 0)
      changes.push_back({&*same, &row, row.ns_per_ray / same->ns_per_ray});
  }
}

bool is_wronger(const Accuracy& before, const Accuracy& now) {
  return now.wrong_hits + now.wrong_misses > before.wrong_hits + before.wrong_misses ||
         now.max_ulp > before.max_ulp;
}

/// Whether three quarters of the passes of the one took longer than three quarters of the other's.
bool is_beyond_spread(const BenchRow& longer, const BenchRow& shorter, double machines) {
  if (longer.passes_ns.empty() || shorter.passes_ns.empty()) return true;
  return quantile(longer.passes_ns, 0.25) > machines * quantile(shorter.passes_ns, 0.75);
}

}  // namespace

ReportComparison compare(const Measurements& before, const Measurements& now) {
  std::vector<Change> changes;
  add_common(before.rows, now.rows, changes);
  add_common(before.scaling, now.scaling, changes);
  ReportComparison result{.rows = changes.size()};
  if (changes.empty()) return result;
  std::vector<double> ratios;
  for (const Change& change : changes) ratios.push_back(change.slowdown);
  result.machines = median(ratios);

  for (Change& change : changes) {
    const auto& [old_row, new_row, ratio] = change;
    change.slowdown = ratio / result.machines;
    if (old_row->accuracy.cases != new_row->accuracy.cases)
      ++result.other;
    else if (is_wronger(old_row->accuracy, new_row->accuracy))
      result.wronger.push_back(change);
    if (change.slowdown > notable && is_beyond_spread(*new_row, *old_row, result.machines))
      result.slower.push_back(change);
    if (change.slowdown < 1 / notable && is_beyond_spread(*old_row, *new_row, 1 / result.machines))
      result.faster.push_back(change);
  }
  std::ranges::sort(result.slower, std::greater{}, &Change::slowdown);
  std::ranges::sort(result.faster, std::less{}, &Change::slowdown);
  return result;
}

}  // namespace rayproof::report
