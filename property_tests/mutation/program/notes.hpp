#pragma once
/// \file
/// What the method as it is meets on its way through the cases: which mutants, and where one makes a
/// difference.

#include <vector>

#include "mutation/program/target.hpp"
#include "mutation/program/transcript.hpp"

namespace rayproof::mutation {

/// What was noted of one mutant.
struct Note {
  bool is_reached = false;  ///< its place is
  bool is_met = false;      ///< and there it compiles
  /// The cases, by number, in which the mutated expression has another value. In all others the mutant can
  /// change nothing, since all is as it was up to there.
  std::vector<bool> differs{};
};

/// What was noted of all of them, and the property that the unmutated method breaks, if any.
struct Notes {
  std::vector<Note> of{};                 ///< by the mutant's number
  std::vector<Judged> known{};            ///< the method's answers, by the number of the case
  std::vector<Transcript> transcripts{};  ///< and what it is asked beside, likewise
  const Property* broken = nullptr;
  const Input* broken_in = nullptr;
};

/// Runs the method as it is over all the cases.
[[nodiscard]] Notes note_all(const Target& target, const std::vector<Input>& inputs,
                             const std::vector<int>& mutants);

}  // namespace rayproof::mutation
