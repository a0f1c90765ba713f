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
  /// Turns to those cases of the run that none of the causes explains, where there are enough of them: a
  /// fault that many cases show hides another that few do.
  [[nodiscard]] bool turn_to_rest(std::span<const Hypothesis* const> causes);
  /// The findings that the rest deserves beside the causes that are known.
  [[nodiscard]] std::vector<Finding> findings_of_rest(const std::vector<Diagnosis>& groups,
                                                      std::span<const Hypothesis* const> known) const;

 private:
  void add_right_answers(const Samples& samples);
  void add_neighbours();
  void add_simple_twins();
  [[nodiscard]] std::vector<Case> unexplained(std::vector<Case> left,
                                              std::span<const Hypothesis* const> causes) const;
  [[nodiscard]] bool is_ordinary(const Case& one) const;
  [[nodiscard]] bool is_of_wrong_plane(const Diagnosis& own) const;
  [[nodiscard]] const Diagnosis& own_group(const std::vector<Diagnosis>& groups) const;
  [[nodiscard]] Diagnosis of_its_size(const Diagnosis& group, const Case& simplest) const;
  void describe(Finding& finding, const Diagnosis& group) const;
  [[nodiscard]] std::optional<Case> most_striking(const Diagnosis& group) const;
  [[nodiscard]] std::optional<Finding> of_group(const Diagnosis& group) const;
  [[nodiscard]] std::optional<std::size_t> first_of(const Diagnosis& group, std::span<const Case> cases,
                                                    bool is_plain) const;

  Finding& finding_;
  const std::atomic<bool>& stop_;
  const Samples::PropertySample* sample_;
  Complaint complaint_;
  std::vector<Case> hiding_{};  ///< the sample before the rest was turned to
  std::uint64_t broken_;
};

}  // namespace rayproof::diagnosis
