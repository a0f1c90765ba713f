#pragma once
/// \file
/// What the properties ask of a method on one case. A mutant that gives the same answers to all of it breaks
/// none of them, and nobody need ask the oracle again.

#include <utility>
#include <vector>

#include "case/case.hpp"
#include "subjects/subject.hpp"

namespace rayproof::mutation {

/// The questions given to a method, and what it said.
struct Transcript {
  std::vector<std::pair<Case, Answer>> answers{};
  std::vector<std::pair<Case, std::vector<std::pair<double, double>>>> bounds{};
  std::vector<std::pair<Case, bool>> doubts{}, exactness{};
};

/// Bit for bit, -0 and 0 apart.
[[nodiscard]] bool is_identical(const Answer& a, const Answer& b);

/// The subject, which writes what it is asked into the transcript. One at a time: its functions are plain
/// ones, and both must live as long as they are asked.
[[nodiscard]] Subject recorded(const Subject& subject, Transcript& transcript);

/// Whether the subject says the same to the same questions.
[[nodiscard]] bool repeats(const Subject& subject, const Transcript& transcript);

}  // namespace rayproof::mutation
