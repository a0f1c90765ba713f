#pragma once
/// \file
/// Models of a sphere that is taken for a little smaller or larger, by a share of some length.

#include <cmath>

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// What passes the centre farther away than the radius, less a share of the origin's distance, is missed:
/// one answer for each share from 10^-2 to 10^-5.
[[nodiscard]] Answers passing_near_rim_missed(const Case& one, const Answer& exact);
/// Whether the ray passes deeper under the surface than a tangent, rounded, does.
[[nodiscard]] bool passes_below_surface(const Case& one, const Answer& exact);

/// From nearer than the radius, and a share of it, the far hit alone is given: the origin is taken to lie
/// inside. One answer for each share from a fifth to 10^-4.
[[nodiscard]] Answers far_hit_from_near(const Case& one, const Answer& exact);
/// Whether the origin lies outside.
[[nodiscard]] bool starts_outside(const Case& one, const Answer& exact);

/// A sphere whose centre is farther from the origin than 10^power is missed.
[[nodiscard]] Answers far_centre_missed(const Case& one, const Answer& exact, double limit);
template <int power>
[[nodiscard]] Answers far_centre_missed(const Case& one, const Answer& exact) {
  return far_centre_missed(one, exact, std::pow(10.0, power));
}

/// Whether a hit's t is no larger than that: a limit of t would not leave it out.
[[nodiscard]] bool has_hit_within(const Answer& exact, double limit);
template <int power>
[[nodiscard]] bool has_hit_within(const Case& /*one*/, const Answer& exact) {
  return has_hit_within(exact, std::pow(10.0, power));
}

}  // namespace rayproof::diagnosis
