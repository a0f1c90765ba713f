#pragma once
/// \file
/// Models of the slab method as it is computed: by a reciprocal of the direction that is kept in a float, or
/// is infinite, and with comparisons that are false of NaN.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// The reciprocals of the direction are floats, though the case is of float64.
[[nodiscard]] Answers reciprocal_in_float(const Case& one, const Answer& exact);

/// A ray in the plane of a face: 0·∞ is NaN there. One answer for each way to take the slabs together, by
/// comparisons or by min and max.
[[nodiscard]] Answers nan_in_slab(const Case& one, const Answer& exact);

/// The slabs that come after one which the line runs along are not looked at: one answer for each order.
[[nodiscard]] Answers stops_at_parallel_slab(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
