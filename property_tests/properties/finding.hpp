#pragma once
/// \file
/// Findings: a subject, a property, and the case that breaks it.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "properties/finding_kind.hpp"
#include "properties/property.hpp"
#include "subjects/command.hpp"

namespace rayproof {

struct Hypothesis;

/// What a cause is called, whatever its limit; defined where the causes are.
[[nodiscard]] std::string_view name_without_limit(const Hypothesis& cause);

/// One broken property; of several faults that break it, one.
struct Finding {
  std::size_t number = 0;  ///< from 1: the line in the findings file of the run; 0 before they are in order
  const Subject* subject = nullptr;
  const Property* property = nullptr;
  std::string family{};  ///< where the case came from: a family's name, or "corpus"
  Case one{};
  Evidence evidence{};
  bool is_declared = false;  ///< the subject is known to break it, and says so
  const Hypothesis* cause =
      nullptr;  ///< what explains or cures it, once it is diagnosed; null where nothing does
  std::optional<FindingKind> kind_of_fault{};  ///< as the diagnosis has it
  bool is_beyond_rounding = false;             ///< most cases of the fault are wronger than by lost digits
  std::string diagnosis{};                     ///< the same as a sentence; empty before it is diagnosed
  std::uint64_t cases = 0;                     ///< about how many of the run's cases this fault broke
  std::optional<Case> striking{};              ///< the case that it breaks worst, where that is another
};

/// Whether it was found by a twin of a case: scaled, reversed or moved.
[[nodiscard]] inline bool breaks_symmetry(const Finding& finding) {
  const Claim claim = finding.property->claim;
  return claim == Claim::scaled || claim == Claim::reversed || claim == Claim::moved;
}

/// The finding as a line of JSON without its newline, as the case format says; the evidence's note is the
/// case's.
[[nodiscard]] std::string write_finding(const Finding& finding);

/// A line to be tested again: a finding, or a bare case, for which subject and property are
/// empty.
struct Replayed {
  std::string subject{};
  std::string property{};
  std::string command{};  ///< the shell line of a subject that is one
  /// How long that may be silent while a case waits.
  std::chrono::milliseconds case_time{usual_case_time};
  Case one{};
};

/// Reads a finding or a case. Throws a Refusal.
[[nodiscard]] Replayed read_replayed(std::string_view line);

}  // namespace rayproof
