#pragma once
/// \file
/// Models of faults in the question whether a point lies on a side of a polygon.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// An end of a side, in x or in y.
enum class EndOfSide { right, left, upper, lower };

/// A point of the boundary is said to be outside, or inside, where all sides that hold it end there in that
/// coordinate: they are taken without that end. A side that has no extent in it may have no point at all
/// then.
[[nodiscard]] Answers lost_at_end(const Case& one, const Answer& exact, EndOfSide end);
template <EndOfSide end>
[[nodiscard]] Answers lost_at_end(const Case& one, const Answer& exact) {
  return lost_at_end(one, exact, end);
}

/// Every point is said to be on the boundary of a polygon that has a side without length.
[[nodiscard]] Answers on_side_without_length(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
