#pragma once
/// \file
/// Models of faults in how a ray touches a surface, and where a point lies on a boundary.

#include <cmath>

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// A hit that first touches in that manner is missed.
template <Contact contact>
[[nodiscard]] Answers misses_at(const Case& /*one*/, const Answer& exact) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (answer == nullptr || answer->hits.count == 0 || answer->contact != contact) return {};
  return {RayAnswer{}};
}
/// A ray that touches, along an axis, is missed; of other such rays rounding decides.
[[nodiscard]] Answers misses_tangents_along_axes(const Case& one, const Answer& exact);
/// A hit on an edge or a vertex is missed; where `Position` is asked, the boundary is outside.
[[nodiscard]] Answers boundary_is_outside(const Case& one, const Answer& exact);
/// The boundary of a polygon in the plane is inside.
[[nodiscard]] Answers boundary_is_inside(const Case& one, const Answer& exact);
/// A ray that runs inside the surface is a hit, or its contact is something else.
[[nodiscard]] std::optional<bool> in_surface_is_hit(const Case& one, const Answer& got, const Answer& exact);
/// A hit that first touches in one manner is called another one.
template <Contact from, Contact to>
[[nodiscard]] Answers called(const Case& /*one*/, const Answer& exact) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (answer == nullptr || answer->hits.count == 0 || answer->contact != from) return {};
  RayAnswer other = *answer;
  other.contact = to;
  return {other};
}
/// A hit of a triangle is called edge where a barycentric coordinate is below a limit, and vertex where two
/// are.
[[nodiscard]] Answers called_by_weights(const Case& one, const Answer& exact, double limit);
template <int power>
[[nodiscard]] Answers called_by_weights(const Case& one, const Answer& exact) {
  return called_by_weights(one, exact, std::pow(10.0, power));
}
/// A ray that runs inside a plane is called parallel.
[[nodiscard]] Answers in_surface_is_parallel(const Case& one, const Answer& exact);
/// Rays inside the plane are called parallel, and those parallel to it are said to be inside.
[[nodiscard]] Answers reasons_exchanged(const Case& one, const Answer& exact);
/// The reason why a ray misses is not given.
[[nodiscard]] Answers no_reason(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
