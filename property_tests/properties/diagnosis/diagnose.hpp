#pragma once
/// \file
/// The diagnosis: failing cases of one property grouped by what cures them, each group with its cause in
/// words.

#include <string>

#include "properties/diagnosis/hypothesis.hpp"
#include "properties/diagnosis/patient.hpp"

namespace rayproof {

/// One fault, as far as is known.
struct Diagnosis {
  const Hypothesis* cause = nullptr;  ///< null where nothing tried explains or cures it
  FindingKind kind = FindingKind::gross;
  std::string sentence{};            ///< what is wrong, in words
  bool is_beyond_rounding = false;   ///< most of the cases are wronger than lost digits can make them
  std::vector<std::size_t> cases{};  ///< of the failing cases, by index, ascending
};

/// The faults behind the failing cases, those of most cases first: every failing case belongs to one.
///
/// A hypothesis explains a case where the model predicts the subject's wrong answer, or the subject is right
/// after the cure; it must explain most of the failing cases of its group, and a model must not contradict
/// what the subject says where it is right: that is what `passing` cases are for. Where none explains most,
/// the one that explains the largest part makes a group, and the rest is looked at again. The outcome depends
/// on nothing but the answers.
///
/// A fault that is `known` of the subject is taken first, where it explains as much as is asked of any. After
/// the first group a cure must help in a good part of all cases to make another: small rests are rounding.
[[nodiscard]] std::vector<Diagnosis> diagnose(const Patient& patient, std::span<const Case> failing,
                                              std::span<const Case> passing,
                                              std::span<const Hypothesis* const> known = {});

/// A sample of the cases on which a subject breaks one property in one precision, and of those to which it
/// answers rightly.
struct Complaint {
  Patient patient{};
  std::vector<Case> failing{}, passing{};
  double broken = 0;  ///< how many cases of the run it stands for; 0 for those of the sample alone
};

/// The faults behind all complaints of one subject, for each complaint its groups. As few causes are named as
/// explain all: what explains many cases of several complaints is preferred to what happens to explain one.
[[nodiscard]] std::vector<std::vector<Diagnosis>> diagnose_together(
    std::span<const Complaint* const> complaints);

/// Whether the hypothesis explains the patient's wrong answer to the case.
[[nodiscard]] bool explains(const Patient& patient, const Hypothesis& hypothesis, const Case& one);

}  // namespace rayproof
