#pragma once
/// \file
/// Models of faults in the normal of the first hit.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// @{ Normals: on the side of the ray's origin whatever the surface says; on the wrong side; not of unit
/// length; in the object's space; carried to the world by the matrix and not by its inverse transpose; from
/// the origin of coordinates.
[[nodiscard]] Answers normal_faces_ray(const Case& one, const Answer& exact);
[[nodiscard]] Answers normal_follows_ray(const Case& one, const Answer& exact);
[[nodiscard]] Answers normal_flipped(const Case& one, const Answer& exact);
/// Turned round where the transform mirrors the object.
[[nodiscard]] Answers normal_flipped_by_mirror(const Case& one, const Answer& exact);
/// Turned round where the edges of a parallelepiped are left-handed.
[[nodiscard]] Answers normal_flipped_by_edges(const Case& one, const Answer& exact);
/// At the hit that lies behind the ray's beginning, where the ray starts inside.
[[nodiscard]] Answers normal_of_near_hit(const Case& one, const Answer& exact);
/// The normal is that of the far hit: always, or where the ray heads to the middle of its chord, or away.
[[nodiscard]] Answers normal_of_far_hit(const Case& one, const Answer& exact);
[[nodiscard]] std::optional<bool> normal_not_unit(const Case& one, const Answer& got, const Answer& exact);
[[nodiscard]] Answers normal_in_object(const Case& one, const Answer& exact);
[[nodiscard]] Answers normal_by_matrix(const Case& one, const Answer& exact);
/// The normal is carried by the columns of the matrix, each over the square of its length: right of a turn
/// and a scale along the axes of the object alone.
[[nodiscard]] Answers normal_by_columns(const Case& one, const Answer& exact);
/// The normal is carried by the inverse that is not transposed.
[[nodiscard]] Answers normal_by_inverse(const Case& one, const Answer& exact);
/// The normal, of length 1, is carried as a point: the translation is added to it.
[[nodiscard]] Answers normal_moved(const Case& one, const Answer& exact);
[[nodiscard]] Answers normal_from_zero(const Case& one, const Answer& exact);
/// The ray's direction, reversed.
[[nodiscard]] Answers normal_is_direction(const Case& one, const Answer& exact);
/// From the middle of a solid; with no component below 0.
[[nodiscard]] Answers normal_from_middle(const Case& one, const Answer& exact);
[[nodiscard]] Answers normal_without_signs(const Case& one, const Answer& exact);
/// A polygon's, turned as its first corner turns.
[[nodiscard]] Answers normal_of_first_corner(const Case& one, const Answer& exact);
/// The normal of a polygon is the cross product of the ways from the mean of its vertices to two that follow
/// each other: the first and the second, the last and the first, or the second and the third. An answer for
/// each.
[[nodiscard]] Answers normal_about_mean(const Case& one, const Answer& exact);
/// A box's normal along another axis, or between axes.
[[nodiscard]] std::optional<bool> normal_of_other_face(const Case& one, const Answer& got,
                                                       const Answer& exact);
/// @}

/// The normal of the line's other hit: entry and exit are exchanged.
[[nodiscard]] Answers normal_of_other_hit(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
