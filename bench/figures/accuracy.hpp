#pragma once
/// \file
/// A method's errors over many cases, judged by the oracle.

#include <span>
#include <vector>

#include "bench/figures/row.hpp"
#include "case/answer.hpp"
#include "generators/generators.hpp"
#include "subjects/subject.hpp"

namespace rayproof::report {

/// The cases of one family in one precision, and the exact answers to the first of them, which are judged.
struct JudgedFamily {
  std::vector<Case> cases;
  std::vector<Answer> exact;
};

/// Generates `count` cases of a family and answers the first `judged_count` of them exactly.
[[nodiscard]] JudgedFamily judged_family(const Family& family, Precision precision, std::size_t count,
                                         std::size_t judged_count);

/// A subject's errors in both arrangements; without cases where the subject has no batch.
struct Accuracies {
  Accuracy scalar;
  Accuracy batch;
};

/// Judges subjects on a family, on all threads. A subject that knows of no interval (GLM reports the nearest
/// hit beyond 0) is judged only on rays whose interval is [0, inf].
[[nodiscard]] std::vector<Accuracies> measure(std::span<const Subject* const> subjects,
                                              const JudgedFamily& family);

}  // namespace rayproof::report
