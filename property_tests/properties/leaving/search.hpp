#pragma once
/// \file
/// Many situations, left by every strategy, judged and counted.

#include <atomic>
#include <functional>

#include "properties/leaving/strategy.hpp"
#include "properties/leaving/tally.hpp"

namespace rayproof::leaving {

struct SearchSettings {
  std::uint64_t seed = 2022;
  std::uint64_t cases = 2048;             ///< situations for each shape and precision
  int jobs = 0;                           ///< threads; 0 for as many as the machine has
  std::vector<std::string> shapes{};      ///< all where empty
  std::vector<std::string> strategies{};  ///< all where empty
  std::vector<Precision> precisions{Precision::float32, Precision::float64};
};

/// What a strategy has come to on a shape in a precision.
struct StrategyOutcome {
  const Strategy* strategy = nullptr;
  std::string shape{};
  Precision precision{};
  StrategyTally tally{};
};

/// A strategy's ray that meets what it has left, or that skips the solid it was to start in though its
/// strategy is proven.
struct WrongStart {
  const Strategy* strategy = nullptr;
  Situation from{};
  Case left{};  ///< the ray that was started, as a case; its note says how it came about
  bool is_shrunk = false;
};

struct SearchResult {
  std::vector<StrategyOutcome> outcomes{};
  /// The simplest of each strategy, and every one of a proven strategy's.
  std::vector<WrongStart> failures{};
  bool was_interrupted = false;
};

/// Names that there are none of, as one sentence; empty where all are known.
[[nodiscard]] std::string unknown_names(const SearchSettings& settings);

/// Searches. The result is the same for every number of jobs; stops early, with what it has, once `stop` is
/// true. `progress` hears the share that is done and what is being done.
[[nodiscard]] SearchResult search(const SearchSettings& settings, const std::atomic<bool>& stop,
                                  const std::function<void(double, const std::string&)>& progress);

/// The simplest situation like the one found in which the strategy fails.
[[nodiscard]] WrongStart simplest(const Strategy& strategy, const Situation& found,
                                  const std::atomic<bool>& stop);

/// The situation of that number in a search that came to it.
[[nodiscard]] Situation situation_number(const SearchSettings& settings, const std::string& shape,
                                         Precision precision, std::uint64_t number);

}  // namespace rayproof::leaving
