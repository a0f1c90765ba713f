#pragma once
/// \file
/// Models of faults: what a subject that has the fault answers. Each is a Predict or a Recognise of
/// hypothesis.hpp and returns nothing for a case in which the fault does not show.

#include <cmath>

#include "properties/diagnosis/changes.hpp"
#include "properties/diagnosis/hypothesis.hpp"

namespace rayproof::diagnosis {

/// x rounded to a grid with that number of cells for each unit.
[[nodiscard]] inline double on_grid(double x, double cells) { return std::round(x * cells) / cells; }

using Answers = std::vector<Answer>;

/// What a subject answers that reads the case as `changes(one)`.
template <std::vector<Case> (*changes)(const Case&)>
[[nodiscard]] Answers read_as(const Case& one, const Answer& /*exact*/) {
  return exact_of(changes(one));
}

}  // namespace rayproof::diagnosis
