#pragma once
#include <string>

#include "properties/report/summary.hpp"

namespace rayproof {

/// The outcome as JUnit XML: a suite for each method and precision, a test for each property it claims or is
/// declared to break, and a suite for the generators' shares.
[[nodiscard]] std::string junit_report(const Summary& summary, const RunResult& result);

}  // namespace rayproof
