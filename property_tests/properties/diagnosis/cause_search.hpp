#pragma once
/// \file
/// The search for the hypothesis that explains most of some failing cases.

#include "properties/diagnosis/diagnose.hpp"
#include "properties/diagnosis/examination/examination.hpp"
#include "properties/diagnosis/indices.hpp"

namespace rayproof::diagnosis {

/// Whether it is a fault that would break more than count digits from afar.
[[nodiscard]] bool breaks_more_than_digits(const Hypothesis& one);

/// Whether there are more contradictions than another fault, or rounding, may make.
[[nodiscard]] bool is_refuted(const Hypothesis& one, std::size_t explained, std::size_t contradictions);

/// Looks for the cause of the failing cases that are left, one group after the other.
class CauseSearch {
 public:
  CauseSearch(const Patient& patient, const Examination& examination,
              std::span<const Hypothesis* const> known)
      : patient_(patient), examination_(examination), known_(known) {}

  /// Every failing case in a group with its cause; those of most cases first. Only cause and cases are given.
  [[nodiscard]] std::vector<Diagnosis> groups() const;
  /// The causes of the groups; the models of what differs by precision that explain most of all failing
  /// cases; and, where a group's cause is vague, the model that explains most of all.
  [[nodiscard]] std::vector<const Hypothesis*> named() const;
  /// Which of all failing cases it explains, though they may not show all that it says; none where it proves
  /// nothing here.
  [[nodiscard]] Indices explained_of_all(const Hypothesis& one, Examination::Mistake mistake = {}) const;

 private:
  /// What explains most of the cases, or else the largest part of them; no cause where nothing explains
  /// enough.
  [[nodiscard]] Diagnosis next(const Indices& left) const;
  [[nodiscard]] bool is_of_the_asking(const Hypothesis& one, const Indices& left) const;
  [[nodiscard]] bool may_show(const Hypothesis& one) const;
  [[nodiscard]] bool may_be(const Hypothesis& one, bool is_isolated) const;
  [[nodiscard]] bool are_isolated(const Indices& cases, std::size_t percent) const;
  [[nodiscard]] Indices screened(const Hypothesis& one, const Indices& left) const;
  [[nodiscard]] bool is_by_chance(const Hypothesis& one, const Indices& cases) const;
  [[nodiscard]] bool is_too_small_a_share(const Hypothesis& one, const Indices& cases) const;
  [[nodiscard]] bool is_most(const Hypothesis& one, const Indices& cases, const Indices& left) const;
  [[nodiscard]] Diagnosis best_model(const Indices& left, bool is_exact) const;
  [[nodiscard]] std::size_t balance(const Hypothesis& model, const Indices& cases) const;
  [[nodiscard]] bool is_contradicted(const Hypothesis& one, const Indices& cases) const;
  [[nodiscard]] bool is_proven(const Hypothesis& one, const Indices& cases, const Indices& left) const;

  const Patient& patient_;
  const Examination& examination_;
  std::span<const Hypothesis* const> known_;
};

}  // namespace rayproof::diagnosis
