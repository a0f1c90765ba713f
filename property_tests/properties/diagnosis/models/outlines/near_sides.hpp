#pragma once
/// \file
/// Models of tolerances beside the sides of polygons.

#include <cmath>

#include "properties/diagnosis/models/outlines/outline_geometry.hpp"

namespace rayproof::diagnosis {

/// What is no farther from a side than a share of the polygon's size is said to be inside.
[[nodiscard]] Answers near_sides_inside(const Case& one, const Answer& exact, double tolerance);
template <int power>
[[nodiscard]] Answers near_sides_inside(const Case& one, const Answer& exact) {
  return near_sides_inside(one, exact, std::pow(10.0, power));
}

/// A gap between two sides that share no vertex is said to be inside where both are no farther from the
/// point than a share of the polygon's size: they are taken for one.
[[nodiscard]] Answers gap_is_inside(const Case& one, const Answer& exact, double tolerance);
template <int power>
[[nodiscard]] Answers gap_is_inside(const Case& one, const Answer& exact) {
  return gap_is_inside(one, exact, std::pow(10.0, power));
}

/// A point within a side's bounding box is said to be on the boundary where the cross product of the side and
/// its way to the point is below a limit.
[[nodiscard]] Answers near_sides_boundary(const Case& one, const Answer& exact, double limit);
template <int power>
[[nodiscard]] Answers near_sides_boundary(const Case& one, const Answer& exact) {
  return near_sides_boundary(one, exact, std::pow(10.0, power));
}

/// A point that is nearer to a side than a limit is said to be on the boundary.
[[nodiscard]] Answers within_of_boundary(const Case& one, const Answer& exact, double limit);
template <int power>
[[nodiscard]] Answers within_of_boundary(const Case& one, const Answer& exact) {
  return within_of_boundary(one, exact, std::pow(10.0, power));
}

}  // namespace rayproof::diagnosis
