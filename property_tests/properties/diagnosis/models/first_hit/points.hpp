#pragma once
/// \file
/// Models of faults in the point of the first hit.

#include <cmath>

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// The answer where it gives the point of a hit, else null.
[[nodiscard]] const RayAnswer* hit_with_point(const Answer& exact);

/// @{ Points: in the object's space; not from the ray's origin; at the farthest hit; right although t is
/// wrong.
[[nodiscard]] Answers point_in_object(const Case& one, const Answer& exact);
[[nodiscard]] Answers point_without_origin(const Case& one, const Answer& exact);
/// o + t·d/|d|; o - t·d; and in coordinates from the shape's own point, its centre or corner.
[[nodiscard]] Answers point_by_unit_direction(const Case& one, const Answer& exact);
[[nodiscard]] Answers point_against_direction(const Case& one, const Answer& exact);
[[nodiscard]] Answers point_from_shape(const Case& one, const Answer& exact);
/// On the sphere of radius 1 about the centre: the normal is added to it, and not the normal times the
/// radius.
[[nodiscard]] Answers point_at_radius_one(const Case& one, const Answer& exact);
/// Whether the point is off the surface by some length along the normal, as an origin of the next ray is.
[[nodiscard]] std::optional<bool> point_moved_along_normal(const Case& one, const Answer& got,
                                                           const Answer& exact);
/// The point is taken back to the world without the matrix's translation.
[[nodiscard]] Answers point_without_translation(const Case& one, const Answer& exact);
/// A triangle's barycentric coordinates are rounded to multiples of 10^-decimals.
[[nodiscard]] Answers weights_on_grid(const Answer& exact, double cells);
template <int decimals>
[[nodiscard]] Answers weights_to_decimals(const Case& /*one*/, const Answer& exact) {
  return weights_on_grid(exact, std::pow(10.0, decimals));
}
/// Whether the point is one of multiples of 10^-decimals, which the right one is not.
[[nodiscard]] std::optional<bool> point_on_grid(const Answer& got, const Answer& exact, double cells);
template <int decimals>
[[nodiscard]] std::optional<bool> point_to_decimals(const Case& /*one*/, const Answer& got,
                                                    const Answer& exact) {
  return point_on_grid(got, exact, std::pow(10.0, decimals));
}
/// Two or three barycentric coordinates are exchanged where a triangle's normal is largest along an axis. An
/// answer for each such mistake.
[[nodiscard]] Answers weights_exchanged_along_axis(const Case& one, const Answer& exact);
/// o + r·d of a sphere, and o + d.
[[nodiscard]] Answers point_at_radius(const Case& one, const Answer& exact);
[[nodiscard]] Answers point_at_direction(const Case& one, const Answer& exact);
/// The point of a plane that is nearest to the ray's origin.
[[nodiscard]] Answers point_at_foot(const Case& one, const Answer& exact);
/// Whether the point lies beside the ray's line.
[[nodiscard]] std::optional<bool> point_beside_ray(const Case& one, const Answer& got, const Answer& exact);
[[nodiscard]] Answers point_of_far_hit(const Case& one, const Answer& exact);
[[nodiscard]] std::optional<bool> point_right_t_wrong(const Case& one, const Answer& got,
                                                      const Answer& exact);
/// @}

}  // namespace rayproof::diagnosis
