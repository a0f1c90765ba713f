#pragma once
/// \file
/// The findings of a run diagnosed: each gets its cause, and of several faults each its own finding.

#include <atomic>

#include "properties/engine.hpp"
#include "properties/samples.hpp"

namespace rayproof {

/// Diagnoses each finding by the failing cases of its subject, property and precision. A finding keeps its
/// case and gets the cause that explains it. Where a contract is broken by other faults, too, a finding is
/// added for each, its simplest case shrunk as far as the fault stays the same; of what is declared broken,
/// one counterexample is enough. The result does not depend on the number of threads. Stops early, with what
/// it has, once `stop` is true.
void diagnose_findings(RunResult& result, const Samples& samples, const Listener& listener,
                       const std::atomic<bool>& stop);

}  // namespace rayproof
