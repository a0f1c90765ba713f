#pragma once
/// \file
/// Models of tolerances at the edges of a triangle.

#include <cmath>

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// The hits of the triangle's plane whose barycentric coordinates are at least so much: all three, or that of
/// a, of b, of c, and the others at least 0; and those whose areas add up to so much more than the whole.
/// None where it cannot change the verdict: what is loose loses no hit, what is tight finds none.
[[nodiscard]] Answers within_weights(const Case& one, const Answer& exact, double least);
/// Hits beside the triangle count where no barycentric coordinate is below -10^power; hits inside are left
/// out where one is below 10^power.
template <int power>
[[nodiscard]] Answers edges_with_tolerance(const Case& one, const Answer& exact) {
  return within_weights(one, exact, -std::pow(10.0, power));
}
template <int power>
[[nodiscard]] Answers edges_tight(const Case& one, const Answer& exact) {
  return within_weights(one, exact, std::pow(10.0, power));
}

/// The areas of the three triangles between a point and the edges may add up to so much more than the whole.
[[nodiscard]] Answers within_area(const Case& one, double more);
template <int power>
[[nodiscard]] Answers areas_with_tolerance(const Case& one, const Answer& /*exact*/) {
  return within_area(one, std::pow(10.0, power));
}

}  // namespace rayproof::diagnosis
