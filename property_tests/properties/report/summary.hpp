#pragma once
/// \file
/// What a run says of each subject and property: does it keep what it claims?

#include <array>
#include <string>
#include <vector>

#include "properties/engine/engine.hpp"

namespace rayproof {

/// A subject's standing on a property, from what says nothing to what a reader must see.
enum class ClaimStatus {
  unclaimed,  ///< neither claimed nor declared broken
  untested,   ///< claimed, but no case was one the property speaks of
  spared,     ///< declared broken as part of a claim of which another part was refuted
  holds,      ///< claimed, and never seen broken
  refuted,    ///< declared broken, and a counterexample was found
  unrefuted,  ///< declared broken, but no counterexample was found
  broken      ///< claimed, and broken: the contract does not hold
};

/// How a status is shown: a mark and words, so that neither colour nor font decides, and its class on the
/// page.
struct StatusText {
  const char* sign;
  const char* words;
  const char* style;
};
[[nodiscard]] const StatusText& text_of(ClaimStatus status);

/// Those that the tables explain.
inline constexpr std::array statuses_in_legend{ClaimStatus::holds,  ClaimStatus::refuted,
                                               ClaimStatus::broken, ClaimStatus::unrefuted,
                                               ClaimStatus::spared, ClaimStatus::untested};

/// Whether a status makes the run fail.
[[nodiscard]] inline bool is_failure(ClaimStatus status) { return status >= ClaimStatus::unrefuted; }

/// One property of a row.
struct Cell {
  const Property* property = nullptr;
  ClaimStatus status = ClaimStatus::unclaimed;
  PropertyTally tally{};
};

/// One subject at one precision, over all families.
struct Row {
  const Subject* subject = nullptr;
  Precision precision{};
  std::uint64_t cases = 0;
  Worst worst{};  ///< over the families without transforms: what the contract's bounds speak of
  std::vector<Cell> cells{};

  [[nodiscard]] bool is_measured() const { return worst.cases > 0; }
};

/// The whole run.
struct Summary {
  std::vector<Row> rows{};
  std::vector<std::string> missed_shares{};
  bool was_interrupted = false;

  /// Every contract holds, every declared refutation was found, every share of the generators was kept.
  [[nodiscard]] bool is_success() const { return failures().empty(); }
  /// What makes the run fail, each as a sentence.
  [[nodiscard]] std::vector<std::string> failures() const {
    return sentences({ClaimStatus::broken, ClaimStatus::unrefuted});
  }
  /// Those of them that no finding shows: what was declared broken and not refuted, what a generator missed.
  [[nodiscard]] std::vector<std::string> without_counterexample() const {
    return sentences({ClaimStatus::unrefuted});
  }

 private:
  /// Of each cell with one of the statuses, and of each missed share.
  [[nodiscard]] std::vector<std::string> sentences(std::initializer_list<ClaimStatus> statuses) const;
};

[[nodiscard]] Summary summarise(const Plan& plan, const RunResult& result);

/// The finding that breaks the property of a row, or null.
[[nodiscard]] const Finding* find_finding(const RunResult& result, const Row& row, const Property& property);

/// A bound's figures, "0.93 of 8" or "0.93" where nothing is promised.
[[nodiscard]] std::string figure(double measured, double promised);
/// An error as people read it: "0", "0.93", "1.2e+05".
[[nodiscard]] std::string figure(double measured);

}  // namespace rayproof
