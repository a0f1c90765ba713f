#pragma once
/// \file
/// The engine: runs every subject on every family under rapidcheck, shrinks what breaks, and adds up.

#include "properties/engine/hunt.hpp"
#include "properties/engine/labels.hpp"
#include "properties/engine/plan.hpp"
#include "properties/finding.hpp"

namespace rayproof {

/// What a run has found out so far.
struct RunResult {
  std::vector<Unit> units{};
  std::vector<Finding> findings{};
  std::vector<LabelCount> labels{};
  std::size_t corpus_cases = 0;
  bool was_interrupted = false;
};

/// Who hears from the engine. All are called from the thread that called `run_plan`.
struct Listener {
  /// What is being done, and the share of the whole run that is done, 0 to 1.
  std::function<void(const std::string& what, double done)> progress = [](const std::string&, double) {};
  /// A case has broken a property; it is about to be shrunk.
  std::function<void(const Finding&)> broken = [](const Finding&) {};
  /// The same, shrunk: what is reported to people.
  std::function<void(const Finding&)> finding = [](const Finding&) {};
};

/// Runs the plan: the corpus first, then the labels, then the families. Stops early, with what it has, once
/// `stop` is true. The result is the same for every number of jobs.
[[nodiscard]] RunResult run_plan(const Plan& plan, const std::vector<Case>& corpus, const Listener& listener,
                                 const std::atomic<bool>& stop);

}  // namespace rayproof
