#pragma once
/// \file
/// Models of faults with where the ray starts beside the shape.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// A shape is missed whose middle, or the mean of its vertices, lies behind the ray's origin.
[[nodiscard]] Answers missed_with_middle_behind(const Case& one, const Answer& exact);
/// @{ A surface is missed from an origin on that side of its plane: where the normal points, or not.
[[nodiscard]] Answers missed_from_front(const Case& one, const Answer& exact);
[[nodiscard]] Answers missed_from_back(const Case& one, const Answer& exact);
/// @}

}  // namespace rayproof::diagnosis
