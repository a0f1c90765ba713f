#pragma once
/// \file
/// Models of faults in where a side of a polygon crosses the level of the point.

#include "properties/diagnosis/models/models.hpp"
#include "properties/diagnosis/models/outlines/sweep.hpp"

namespace rayproof::diagnosis {

/// What a subject answers that counts even and odd crossings and makes one mistake where it computes the x of
/// a crossing: for each mistake one answer, always in the same order. None where a vertex is level with the
/// point, and on the boundary.
[[nodiscard]] Answers wrong_crossing(const Case& one, const Answer& exact, Sweep sweep);
template <Sweep sweep>
[[nodiscard]] Answers wrong_crossing(const Case& one, const Answer& exact) {
  return wrong_crossing(one, exact, sweep);
}

}  // namespace rayproof::diagnosis
