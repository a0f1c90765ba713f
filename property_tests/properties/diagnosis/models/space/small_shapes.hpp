#pragma once
/// \file
/// Models of subjects that take what is small for nothing: a shape, or a component of the direction.

#include <cmath>

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// A solid that is thinner than `least` is missed: the radius of a sphere, the smallest side of a box, the
/// smaller radius or the height of a cylinder.
[[nodiscard]] Answers thin_solid_missed(const Case& one, const Answer& exact, double least);
template <int power>
[[nodiscard]] Answers thin_solid_missed(const Case& one, const Answer& exact) {
  return thin_solid_missed(one, exact, std::pow(10.0, power));
}
/// A triangle or polygon with an area below `least` is missed. Where it is below by less than a factor of two
/// anything may be: twice the area may be what is compared.
[[nodiscard]] Answers small_area_missed(const Case& one, const Answer& exact, double least);
template <int power>
[[nodiscard]] Answers small_area_missed(const Case& one, const Answer& exact) {
  return small_area_missed(one, exact, std::pow(10.0, power));
}
/// Whether that thickness or area is not 0.
[[nodiscard]] bool has_some_size(const Case& one, const Answer& exact);

/// What the ray meets, in object space, where components of its direction that are smaller than `least` are
/// made as large: with their signs, or all positive.
[[nodiscard]] std::vector<Case> components_raised(const Case& one, double least);
template <int power>
[[nodiscard]] std::vector<Case> components_raised(const Case& one) {
  return components_raised(one, std::pow(10.0, power));
}

/// Whether one of them is not 0.
[[nodiscard]] bool has_component_below(const Case& one, double least);
template <int power>
[[nodiscard]] bool has_component_below(const Case& one, const Answer& /*exact*/) {
  return has_component_below(one, std::pow(10.0, power));
}

}  // namespace rayproof::diagnosis
