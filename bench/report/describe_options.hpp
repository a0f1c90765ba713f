#pragma once
/// \file
/// The command line of rayproof report.

#include <CLI/CLI.hpp>

#include "bench/figures/options.hpp"

namespace rayproof::report {

/// Describes the options to the command line parser.
void describe(CLI::App& app, BenchOptions& options);

}  // namespace rayproof::report
