#pragma once
/// \file
/// Models of faults in what an answer says of its first hit beside t: normal, point, barycentric coordinates.

#include <cmath>

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
[[nodiscard]] std::optional<bool> normal_not_unit(const Case& one, const Answer& got, const Answer& exact);
[[nodiscard]] Answers normal_in_object(const Case& one, const Answer& exact);
[[nodiscard]] Answers normal_by_matrix(const Case& one, const Answer& exact);
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
/// A box's normal along another axis, or between axes.
[[nodiscard]] std::optional<bool> normal_of_other_face(const Case& one, const Answer& got,
                                                       const Answer& exact);
/// @}

/// @{ Points: in the object's space; not from the ray's origin; at the farthest hit; right although t is
/// wrong.
[[nodiscard]] Answers point_in_object(const Case& one, const Answer& exact);
[[nodiscard]] Answers point_without_origin(const Case& one, const Answer& exact);
/// o + t·d/|d|; o - t·d; and in coordinates from the shape's own point, its centre or corner.
[[nodiscard]] Answers point_by_unit_direction(const Case& one, const Answer& exact);
[[nodiscard]] Answers point_against_direction(const Case& one, const Answer& exact);
[[nodiscard]] Answers point_from_shape(const Case& one, const Answer& exact);
/// Whether the point is off the surface by some length along the normal, as an origin of the next ray is.
[[nodiscard]] std::optional<bool> point_moved_along_normal(const Case& one, const Answer& got,
                                                           const Answer& exact);
/// Whether the point lies beside the ray's line.
[[nodiscard]] std::optional<bool> point_beside_ray(const Case& one, const Answer& got, const Answer& exact);
[[nodiscard]] Answers point_of_far_hit(const Case& one, const Answer& exact);
[[nodiscard]] std::optional<bool> point_right_t_wrong(const Case& one, const Answer& got,
                                                      const Answer& exact);
/// @}

/// The barycentric coordinates in another order: place i holds the one that belongs in `order i`.
template <int x, int y, int z>
[[nodiscard]] Answers in_order(const Case& /*one*/, const Answer& exact) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (answer == nullptr || !answer->barycentric) return {};
  RayAnswer permuted = *answer;
  const glm::dvec3& own = *answer->barycentric;
  permuted.barycentric = {own[x], own[y], own[z]};
  return {permuted};
}

/// Beta, gamma and t in the places of alpha, beta and gamma.
[[nodiscard]] Answers weights_and_t(const Case& one, const Answer& exact);

/// One barycentric coordinate is wrong, and the two others are right.
template <int place>
[[nodiscard]] std::optional<bool> weight_is_wrong(const Case& /*one*/, const Answer& got,
                                                  const Answer& exact) {
  const auto *mine = std::get_if<RayAnswer>(&got), *answer = std::get_if<RayAnswer>(&exact);
  if (mine == nullptr || answer == nullptr || !mine->barycentric || !answer->barycentric) return std::nullopt;
  const auto is_right = [&](int i) {
    return std::abs((*mine->barycentric)[i] - (*answer->barycentric)[i]) < 0x1p-12;
  };
  if (is_right(0) && is_right(1) && is_right(2)) return std::nullopt;
  return !is_right(place) && is_right((place + 1) % 3) && is_right((place + 2) % 3);
}

}  // namespace rayproof::diagnosis
