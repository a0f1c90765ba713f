#pragma once
/// \file
/// A model of faults in a triangle's weights that are found by dot products of its edges.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// With e = b - a, f = c - a and w = p - a the weights are (f·f w·e - e·f w·f) / D and (e·e w·f - e·f w·e) /
/// D, D = e·e f·f - (e·f)²: one of the dot products is another one, or a sign is wrong. An answer for each
/// such mistake, always in the same order.
[[nodiscard]] Answers wrong_dots(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
