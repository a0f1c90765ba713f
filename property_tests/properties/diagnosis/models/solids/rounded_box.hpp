#pragma once
/// \file
/// A model of what boxes lose that are kept by their middle, or by one corner and a size.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// The answer of the box that a rounded centre and rounded half lengths make, or min and a rounded size.
[[nodiscard]] std::optional<bool> is_of_rounded_centre(const Case& one, const Answer& got,
                                                       const Answer& exact);

}  // namespace rayproof::diagnosis
