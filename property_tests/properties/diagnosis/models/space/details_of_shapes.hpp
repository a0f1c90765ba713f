#pragma once
/// \file
/// Models of faults in the normal or the point of one kind of shape.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// The normal of a parallelepiped's face runs along the edge that leads to it, and not across the other two.
[[nodiscard]] Answers normal_along_edge(const Case& one, const Answer& exact);
/// The normals of two of its pairs of faces are exchanged.
[[nodiscard]] Answers normals_exchanged(const Case& one, const Answer& exact, int first, int second);
template <int first, int second>
[[nodiscard]] Answers normals_exchanged(const Case& one, const Answer& exact) {
  return normals_exchanged(one, exact, first, second);
}
/// A triangle's point is put together by its barycentric coordinates in another order.
[[nodiscard]] Answers point_by_other_weights(const Case& one, const Answer& exact);

/// Radii and the height are cut off to whole numbers.
[[nodiscard]] std::vector<Case> whole_sizes(const Case& one);
/// A radius, or a height, of 0 is read as 1.
[[nodiscard]] std::vector<Case> zero_size_as_one(const Case& one);

}  // namespace rayproof::diagnosis
