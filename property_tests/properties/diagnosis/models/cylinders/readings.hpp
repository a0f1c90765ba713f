#pragma once
/// \file
/// Readings of a cylinder: other radii, another height or axis, a box.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// The upright box round the cylinder.
[[nodiscard]] std::vector<Case> cylinder_as_box(const Case& one);

/// @{ Readings of a cylinder: with caps, without them; a circular one of radius rx, of ry; with
/// rx and ry exchanged; squared radii; from -height/2 to height/2; from -height to 0.
[[nodiscard]] std::vector<Case> with_caps(const Case& one);
[[nodiscard]] std::vector<Case> without_caps(const Case& one);
[[nodiscard]] std::vector<Case> circular_rx(const Case& one);
[[nodiscard]] std::vector<Case> circular_ry(const Case& one);
[[nodiscard]] std::vector<Case> radii_exchanged(const Case& one);
[[nodiscard]] std::vector<Case> radii_squared(const Case& one);
[[nodiscard]] std::vector<Case> middle_at_zero(const Case& one);
[[nodiscard]] std::vector<Case> top_at_zero(const Case& one);
/// @}
/// @{ Radii doubled, halved, their roots, their mean for both, 1; height doubled, halved, 1.
[[nodiscard]] std::vector<Case> radii_doubled(const Case& one);
[[nodiscard]] std::vector<Case> radii_halved(const Case& one);
[[nodiscard]] std::vector<Case> radii_rooted(const Case& one);
[[nodiscard]] std::vector<Case> radii_mean(const Case& one);
[[nodiscard]] std::vector<Case> height_doubled(const Case& one);
[[nodiscard]] std::vector<Case> height_halved(const Case& one);
[[nodiscard]] std::vector<Case> radii_one(const Case& one);
[[nodiscard]] std::vector<Case> height_one(const Case& one);
/// @}
/// @{ A radius alone, or the height, is read as its root: the square is forgotten.
[[nodiscard]] std::vector<Case> rx_rooted(const Case& one);
[[nodiscard]] std::vector<Case> ry_rooted(const Case& one);
[[nodiscard]] std::vector<Case> height_rooted(const Case& one);
/// @}
/// The cylinder along another axis of its own space, each axis in the place of the one before.
template <int axis>
[[nodiscard]] std::vector<Case> cylinder_along(const Case& one) {
  return with_shape<Cylinder<double>>(one, [](RayQuestion& asked, Cylinder<double>& /*cylinder*/) {
    asked.ray = ray_in_object(asked);
    asked.transform.reset();
    std::swap(asked.ray.origin[axis], asked.ray.origin.z);
    std::swap(asked.ray.direction[axis], asked.ray.direction.z);
    return true;
  });
}
/// The same with the axes in turn, x for y for z.
template <int axis>
[[nodiscard]] std::vector<Case> cylinder_turned_to(const Case& one) {
  return with_shape<Cylinder<double>>(one, [](RayQuestion& asked, Cylinder<double>& /*cylinder*/) {
    asked.ray = ray_in_object(asked);
    asked.transform.reset();
    for (glm::dvec3* v : {&asked.ray.origin, &asked.ray.direction})
      *v = {(*v)[(axis + 1) % 3], (*v)[(axis + 2) % 3], (*v)[axis]};
    return true;
  });
}

}  // namespace rayproof::diagnosis
