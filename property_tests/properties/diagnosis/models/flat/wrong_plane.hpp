#pragma once
/// \file
/// Models of faults in the plane of a flat shape.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// The plane of a triangle or polygon goes through the origin of coordinates: its constant, n·a, is missing.
[[nodiscard]] Answers plane_through_zero(const Case& one, const Answer& exact);
/// Another vector than u × v stands for the normal of a parametric plane: u + v, u - v, u or v.
[[nodiscard]] Answers normal_is_no_cross_product(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
