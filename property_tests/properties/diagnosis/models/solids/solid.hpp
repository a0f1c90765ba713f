#pragma once
/// \file
/// Models of faults with spheres and boxes.

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// @{ Readings of a sphere: its radius squared, its root, doubled, halved, 1; centred at 0; centred on the
/// other side.
[[nodiscard]] std::vector<Case> radius_squared(const Case& one);
[[nodiscard]] std::vector<Case> radius_doubled(const Case& one);
[[nodiscard]] std::vector<Case> radius_halved(const Case& one);
[[nodiscard]] std::vector<Case> radius_one(const Case& one);
[[nodiscard]] std::vector<Case> sphere_at_zero(const Case& one);
[[nodiscard]] std::vector<Case> sphere_mirrored(const Case& one);
/// @}

/// A box without end along an axis.
template <int axis>
[[nodiscard]] std::vector<Case> endless_box(const Case& one) {
  return with_shape<Box<double>>(one, [](RayQuestion& /*asked*/, Box<double>& box) {
    box.min[axis] = -0x1p60;
    box.max[axis] = 0x1p60;
    return true;
  });
}

/// What a subject answers that does not look at that slab of a box: along it a ray has no end, so that it may
/// find nothing, or what is infinite.
template <int axis>
[[nodiscard]] Answers without_slab(const Case& one, const Answer& exact) {
  Answers answers = read_as<endless_box<axis>>(one, exact);
  if (answers.empty()) return answers;
  const glm::dvec3 d = ray_in_object(*ray_question(one)).direction;
  if (d[(axis + 1) % 3] != 0 || d[(axis + 2) % 3] != 0) return answers;
  RayAnswer endless;
  for (const double t : {-infinity<double>, infinity<double>})
    if (in_interval(ray_question(one)->ray, t)) endless.hits.push_back(t);
  answers.emplace_back(endless);
  if (endless.hits.count > 0) answers.emplace_back(RayAnswer{});
  return answers;
}

/// A multiple of r for r²: everywhere, in half the chord alone, or in the test whether the line passes near
/// enough alone.
[[nodiscard]] Answers radius_for_square(const Case& one, double times);
template <int times>
[[nodiscard]] Answers radius_for_square(const Case& one, const Answer& /*exact*/) {
  return radius_for_square(one, times);
}
/// The sign of r² is wrong in the constant of the sphere's equation.
[[nodiscard]] Answers radius_square_added(const Case& one, const Answer& exact);
/// @{ Of a sphere: hits where the discriminant is negative, by either formula; the line's nearest point to
/// the centre for a hit.
[[nodiscard]] Answers sphere_without_sign(const Case& one, const Answer& exact);
[[nodiscard]] Answers nearest_point_of_line(const Case& one, const Answer& exact);
/// Half of the chord that a sphere cuts from the line: √D / a, without the line's nearest point.
/// t is the distance of the hit from the origin's way from the centre, in radii: that was kept in its place.
[[nodiscard]] Answers t_from_scaled_origin(const Case& one, const Answer& exact);
[[nodiscard]] Answers half_chord(const Case& one, const Answer& exact);
/// Half of the chord is r - d, d the distance of the centre from the line, and must be √(r² - d²).
[[nodiscard]] Answers half_chord_by_difference(const Case& one, const Answer& exact);
/// @}

/// A sphere that is a point is missed.
[[nodiscard]] Answers sphere_of_no_radius_missed(const Case& one, const Answer& exact);

/// A sphere whose centre lies behind the ray's beginning is missed, although the ray starts inside.
[[nodiscard]] Answers centre_behind_missed(const Case& one, const Answer& exact);
/// A sphere whose centre is farther from the origin than t_max, as t or as a length, is missed, although its
/// surface is nearer.
[[nodiscard]] Answers centre_beyond_missed(const Case& one, const Answer& exact);

/// @{ A box of size 0 along an axis is missed; a box whose max is its size.
[[nodiscard]] Answers flat_box_missed(const Case& one, const Answer& exact);
[[nodiscard]] std::vector<Case> max_as_size(const Case& one);
/// @}

}  // namespace rayproof::diagnosis
