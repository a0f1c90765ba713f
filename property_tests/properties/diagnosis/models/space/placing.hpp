#pragma once
/// \file
/// Models of faults in a transform that is applied to the shape, and not by its inverse to the ray. Each is a
/// reading of the case: a shape in the world.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// The transpose of the matrix is taken for its inverse.
[[nodiscard]] std::vector<Case> with_transpose_for_inverse(const Case& one);
/// A sphere's radius is scaled as one of the axes is, or by the mean of all.
[[nodiscard]] std::vector<Case> with_uniform_scale(const Case& one);
/// The upright box round a box's or parallelepiped's corners in the world.
[[nodiscard]] std::vector<Case> bounds_in_world(const Case& one);
/// The upright box between a box's min and max in the world.
[[nodiscard]] std::vector<Case> between_two_corners(const Case& one);
/// A plane's normal is carried to the world by the matrix, and must be by its inverse transpose.
[[nodiscard]] std::vector<Case> plane_normal_by_matrix(const Case& one);
/// @{ A parallelepiped's corner stays where it is; its edges are moved like points.
[[nodiscard]] std::vector<Case> corner_not_moved(const Case& one);
[[nodiscard]] std::vector<Case> edges_translated(const Case& one);
/// @}
/// A triangle or polygon under a transform is missed where the ray passes the sphere round its bounding box,
/// whose radius is scaled by the longest column of the matrix.
[[nodiscard]] Answers beyond_bounding_sphere(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
