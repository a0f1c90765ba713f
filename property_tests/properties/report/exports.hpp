#pragma once
/// \file
/// A run as other programs read it.

#include <string>

#include "properties/report/summary.hpp"

namespace rayproof {

/// All figures of a run as one JSON object: `seed`, `cases`, `success`, `failures`, `methods` (each with its
/// properties, marks, counts and worst errors), `families` (the worst errors of each method on each),
/// `labels`, `findings`. Errors that are not finite are the strings of the case format.
[[nodiscard]] std::string json_report(const Plan& plan, const RunResult& result, const Summary& summary);

/// The outcome as JUnit XML: a suite for each method and precision, a test for each property it claims or is
/// declared to break, and a suite for the generators' shares.
[[nodiscard]] std::string junit_report(const Summary& summary, const RunResult& result);

}  // namespace rayproof
