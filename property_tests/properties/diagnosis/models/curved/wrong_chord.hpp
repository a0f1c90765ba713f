#pragma once
/// \file
/// Models of spheres whose chord is not computed, or whose hits near the ray's origin are left out.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// Half of the chord is taken for the radius, as a length or as t, or for 1: so that every line hits. An
/// answer for each, always in the same order.
[[nodiscard]] Answers half_chord_as_radius(const Case& one, const Answer& exact);

/// Hits nearer to the origin than a length of the sphere are left out: the radius, or twice that; or the
/// sphere is missed where its centre is nearer than the radius and the direction's length. An answer for
/// each, always in the same order.
[[nodiscard]] Answers near_hits_of_sphere_missed(const Case& one, const Answer& exact);
/// Whether the ray starts well outside and passes deep below the surface: from inside, or where it is barely
/// hit, many a fault loses the hit.
[[nodiscard]] bool starts_outside_of_sphere(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
