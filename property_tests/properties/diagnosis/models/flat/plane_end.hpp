#pragma once
/// \file
/// Models of a plane that is taken for one with an end.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// A plane's hits far from the origin of coordinates are dropped: by two coordinates, by all, or by the
/// distance. An answer for each such limit, always in the same order.
[[nodiscard]] Answers plane_ends(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
