#pragma once
/// \file
/// A finding as a report to the makers of the library.

#include <string>

#include "dossier/by_hand.hpp"
#include "dossier/comparison.hpp"
#include "dossier/library.hpp"
#include "dossier/recorded.hpp"

namespace rayproof::dossier {

/// All that is known of a finding: what the library was asked, what it said, and what is right.
struct Dossier {
  RecordedFinding recorded{};
  LibraryFacts library{};
  Reproduction reproduction{};
  HandCalculation right{};
  Comparison comparison{};
  /// Why there is nothing to file, in one sentence; empty where the fault is confirmed by hand.
  std::string objection{};
  /// What the library's documentation says of this fault; empty where it says nothing.
  std::string documentation{};

  /// "glm::intersectRayTriangle hits a triangle at t = -1 where there is no hit".
  [[nodiscard]] std::string title() const { return reproduction.function + " " + comparison.deed; }
};

/// Asks the library again, by the shell line that starts its program. Throws std::runtime_error where that
/// can't be done.
[[nodiscard]] Dossier open_dossier(RecordedFinding recorded, const std::string& command);

/// Markdown, ready to be filed. Nothing in it is of ours.
[[nodiscard]] std::string bug_report(const Dossier& dossier);

/// The numbers that the library was given, "origin = (0, 0, 1), radius = 2".
[[nodiscard]] std::string numbers_in_words(const NamedNumbers& inputs);

}  // namespace rayproof::dossier
