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

  /// The sample of cases.
  [[nodiscard]] const Complaint& complaint() const { return complaint_; }
  /// Completes the finding by the groups of its sample; the others that its property deserves.
  [[nodiscard]] std::vector<Finding> findings(const std::vector<Diagnosis>& groups);

 private:
  void add_right_answers(const Samples& samples);
  void add_neighbours();
  [[nodiscard]] bool is_ordinary(const Case& one) const;
  [[nodiscard]] const Diagnosis& own_group(const std::vector<Diagnosis>& groups) const;
  void describe(Finding& finding, const Diagnosis& group) const;
  [[nodiscard]] std::optional<Case> most_striking(const Diagnosis& group) const;
  [[nodiscard]] std::optional<Finding> of_group(const Diagnosis& group) const;
  [[nodiscard]] std::optional<std::size_t> first_of(const Diagnosis& group,
                                                    std::span<const Case> cases) const;

  Finding& finding_;
  const std::atomic<bool>& stop_;
  Complaint complaint_;
  std::uint64_t broken_;
};

}  // namespace rayproof::diagnosis
