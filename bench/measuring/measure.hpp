#pragma once
/// \file
/// The whole measurement: every method on every family, timed and judged.

#include <atomic>
#include <functional>
#include <string>

#include "bench/figures/options.hpp"
#include "bench/figures/row.hpp"

namespace rayproof::report {

/// Called with what is being done and which share of the work lies behind.
using ProgressListener = std::function<void(double done, const std::string& what)>;

/// Once `stop` is set, what was measured until then.
[[nodiscard]] Measurements measure(const BenchOptions& options, const std::atomic<bool>& stop,
                                   const ProgressListener& listener);

/// The processor, its number of cores, and the instruction set the batches ran in.
[[nodiscard]] std::string machine_name();

}  // namespace rayproof::report
