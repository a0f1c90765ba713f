#pragma once
/// \file
/// Models of a wrong coordinate in a cross product.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// One coordinate is wrong of every cross product, of one of a triangle's two, or of a polygon's normal: a
/// sign, the order, or another coordinate in it.
[[nodiscard]] Answers by_wrong_cross(const Case& one, int axis);
template <int axis>
[[nodiscard]] Answers wrong_cross(const Case& one, const Answer& /*exact*/) {
  return by_wrong_cross(one, axis);
}

}  // namespace rayproof::diagnosis
