#pragma once
/// \file
/// Models of faults in one term of a dot product, of those that a ray makes with a sphere or a plane.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// Of a sphere, l = origin - centre; of a cylinder, in the plane in which its side is the unit circle about
/// 0; of a plane, n its normal.
enum class Product {
  direction_squared,
  way_and_direction,
  way_squared,
  normal_and_direction,
  normal_and_origin
};

/// What a subject answers in whose product the term of that coordinate has the other sign, is missing, or has
/// another coordinate of either vector.
[[nodiscard]] Answers with_wrong_term(const Case& one, Product product, int axis);
template <Product product, int axis>
[[nodiscard]] Answers wrong_term(const Case& one, const Answer& /*exact*/) {
  return with_wrong_term(one, product, axis);
}

}  // namespace rayproof::diagnosis
