#pragma once
/// \file
/// Models of faults in the plane of a flat shape.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// The plane of a triangle or polygon goes through the origin of coordinates: its constant, n·a, is missing.
[[nodiscard]] Answers plane_through_zero(const Case& one, const Answer& exact);
/// The constant n·p of a plane is |n||p|: the cosine of the angle between them is missing.
[[nodiscard]] Answers constant_without_cosine(const Case& one, const Answer& exact);
/// Another vector than u × v stands for the normal of a parametric plane: u + v, u - v, u or v.
[[nodiscard]] Answers normal_is_no_cross_product(const Case& one, const Answer& exact);
/// Of a parametric plane u, v or both are taken for points: its point is subtracted from them.
[[nodiscard]] Answers vectors_as_points(const Case& one, const Answer& exact);
/// A plane in the parametric form is hit only where both parameters lie within some limits.
[[nodiscard]] Answers patch_of_plane(const Case& one, const Answer& exact);
/// A parametric plane is missed whose u and v are less than about 1/4 apart in angle.
[[nodiscard]] std::optional<bool> skewed_is_missed(const Case& one, const Answer& got, const Answer& exact);
/// A polygon's plane goes through the mean of its vertices, and must through the first.
[[nodiscard]] Answers plane_through_mean(const Case& one, const Answer& exact);
/// The point of the first hit is that of the plane through the mean.
[[nodiscard]] Answers point_on_plane_through_mean(const Case& one, const Answer& exact);
/// The hit's point is projected along one axis always, or the vertices are, and the other along that where
/// the normal is largest. An answer for each axis, in both orders of the coordinates left.
[[nodiscard]] Answers projected_along_two_axes(const Case& one, const Answer& exact);
/// A component of Newell's normal, the sum of (b_i - b_j)·(c_i + c_j) over the sides ij, has another sign in
/// one of the factors. An answer for each such mistake, always in the same order.
[[nodiscard]] Answers newell_wrong(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
