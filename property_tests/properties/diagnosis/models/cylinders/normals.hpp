#pragma once
/// \file
/// Models of faults in the normals of a cylinder.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// @{ The side's normal: a circular cylinder's for that of an elliptic one; the point divided by the radii
/// once, and not twice; with the z of the point, which is seen from the base's centre; turned to face the
/// ray.
[[nodiscard]] Answers normal_of_circle(const Case& one, const Answer& exact);
[[nodiscard]] Answers normal_by_radii(const Case& one, const Answer& exact);
[[nodiscard]] Answers normal_keeps_z(const Case& one, const Answer& exact);
[[nodiscard]] Answers side_normal_faces_ray(const Case& one, const Answer& exact);
/// @}
/// @{ The caps' normals: the upper one's for both; both with the other sign.
[[nodiscard]] Answers cap_normals_upward(const Case& one, const Answer& exact);
[[nodiscard]] Answers cap_normals_inward(const Case& one, const Answer& exact);
/// @}

}  // namespace rayproof::diagnosis
