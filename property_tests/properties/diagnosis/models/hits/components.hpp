#pragma once
/// \file
/// Models of components of the direction that are 0, and of numbers so small that they are taken for 0.

#include <cmath>

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// A ray is missed whose direction has no x, y or z, in the world or in object space. An answer for each.
[[nodiscard]] Answers missed_without_component(const Case& one, const Answer& exact);

/// Every number of the case that is smaller than this is read as 0.
[[nodiscard]] std::vector<Case> with_tiny_numbers_as_zero(const Case& one, double least);
template <int power>
[[nodiscard]] std::vector<Case> tiny_numbers_as_zero(const Case& one) {
  return with_tiny_numbers_as_zero(one, std::pow(10.0, power));
}

}  // namespace rayproof::diagnosis
