#pragma once
/// \file
/// The search itself, for any error that cases have: it keeps the worst cases and varies them.

#include <atomic>
#include <chrono>
#include <functional>

#include "generators/generators.hpp"
#include "properties/worst/error_measure.hpp"

namespace rayproof::worst {

/// What is searched: the errors of cases of these families. `errors` is called by several threads at once.
struct Ground {
  std::vector<const Family*> families{};
  Precision precision{};
  std::function<ErrorList(const Case&, bool with_details)> errors{};
};

/// How long: by cases, or, where a time is given, by that. The same seed gives the same search, case by case,
/// whatever the number of threads.
struct Budget {
  std::uint64_t seed = 2022;
  std::uint64_t cases = 100'000;
  std::optional<std::chrono::duration<double>> time{};
};

/// A case with one of its errors, and the family that it was drawn from, or whose case it was varied from.
struct WorstCase {
  Case one{};
  double error = 0;
  const Family* family = nullptr;
};

/// For each kind of error the worst case that was met; nothing where all errors were 0.
struct Climbed {
  std::array<std::optional<WorstCase>, error_kinds> worst{};
  std::uint64_t cases = 0;
};

/// Hears how much of the budget is used, from 0 to 1.
using HearProgress = std::function<void(double)>;

/// Draws cases from the families, and does nothing else.
[[nodiscard]] Climbed draw_only(const Ground& ground, const Budget& budget, const std::atomic<bool>& stop,
                                const HearProgress& progress);

/// Draws cases and varies the worst. For each kind of error and each family one case is climbed from, so that
/// different difficulties are followed side by side, and one more, the worst of all. A case that stays the
/// worst of its family for long is given up for a new draw. `start` are cases to begin with.
[[nodiscard]] Climbed climb(const Ground& ground, const Budget& budget, const std::vector<Case>& start,
                            const std::atomic<bool>& stop, const HearProgress& progress);

}  // namespace rayproof::worst
