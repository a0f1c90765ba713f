#pragma once
/// \file
/// One finding, and what its diagnosis makes of it.

#include <atomic>

#include "properties/diagnosis/diagnose.hpp"
#include "properties/engine/engine.hpp"
#include "properties/engine/samples.hpp"

namespace rayproof::diagnosis {

/// How many cases of the run broke the finding's property.
[[nodiscard]] std::uint64_t broken_cases(const RunResult& result, const Finding& finding);

/// A finding with a sample of the cases on which its subject breaks the property.
class Consultation {
 public:
  Consultation(const RunResult& result, const Samples& samples, Finding& finding,
               const std::atomic<bool>& stop);

  /// Completes the finding; the others that its property deserves. Causes that are `known` of the subject are
  /// tried first, and new ones added.
  [[nodiscard]] std::vector<Finding> findings(std::vector<const Hypothesis*>& known);

 private:
  void add_right_answers(const Samples& samples);
  [[nodiscard]] bool is_ordinary(const Case& one) const;
  [[nodiscard]] const Diagnosis& own_group(const std::vector<Diagnosis>& groups) const;
  void describe(Finding& finding, const Diagnosis& group) const;
  [[nodiscard]] std::optional<Case> most_striking(const Diagnosis& group) const;
  [[nodiscard]] std::optional<Finding> of_group(const Diagnosis& group) const;
  [[nodiscard]] bool is_of(const Diagnosis& group, const Case& one) const;

  Finding& finding_;
  const std::atomic<bool>& stop_;
  Patient patient_;
  std::uint64_t broken_;
  std::vector<Case> failing_{};
  std::vector<Case> passing_{};
};

}  // namespace rayproof::diagnosis
