#pragma once
/// \file
/// Models of a box whose middle, half size or corner is taken wrongly.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// @{ The whole size stands for half of it; min + max for the middle; max for half the size of a box about
/// the origin of coordinates.
[[nodiscard]] std::vector<Case> size_as_half(const Case& one);
[[nodiscard]] std::vector<Case> sum_as_middle(const Case& one);
[[nodiscard]] std::vector<Case> max_as_half_size(const Case& one);
/// @}

/// The box with another coordinate of that corner in the place of its coordinate on axis `to`; where the
/// corners then lie the wrong way round, the box between them or none.
[[nodiscard]] Answers with_corner_copied(const Case& one, glm::dvec3 Box<double>::*corner, int from, int to);
template <glm::dvec3 Box<double>::*corner, int from, int to>
[[nodiscard]] Answers corner_copied(const Case& one, const Answer& /*exact*/) {
  return with_corner_copied(one, corner, from, to);
}

}  // namespace rayproof::diagnosis
