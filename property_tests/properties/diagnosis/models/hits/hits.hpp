#pragma once
/// \file
/// Models of faults in the list of hits, or of roots, and its order.

#include <cmath>

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// Of two hits that are nearer to one another than 10^power in t the second is left out.
[[nodiscard]] Answers near_hits_merged(const Case& one, const Answer& exact, double apart);
template <int power>
[[nodiscard]] Answers near_hits_merged(const Case& one, const Answer& exact) {
  return near_hits_merged(one, exact, std::pow(10.0, power));
}

/// Nothing is ever hit, no point is ever inside, there never is a root.
[[nodiscard]] Answers never_hits(const Case& one, const Answer& exact);
/// What is missed is hit somewhere, what is outside is inside.
[[nodiscard]] std::optional<bool> always_hits(const Case& one, const Answer& got, const Answer& exact);
/// The right hits, and not in ascending order.
[[nodiscard]] std::optional<bool> are_unsorted(const Case& one, const Answer& got, const Answer& exact);
template <class Question>
[[nodiscard]] std::optional<bool> not_sorted(const Case& one, const Answer& got, const Answer& exact) {
  return std::holds_alternative<Question>(one.question) ? are_unsorted(one, got, exact) : std::nullopt;
}
/// A hit is given, and it is a farther one than the nearest.
[[nodiscard]] std::optional<bool> not_nearest(const Case& one, const Answer& got, const Answer& exact);
/// Hits or roots in descending order.
[[nodiscard]] Answers descending(const Case& one, const Answer& exact);
/// Those of (-b + √D)/2a and (-b - √D)/2a in this order: descending where a > 0.
[[nodiscard]] Answers plus_root_first(const Case& one, const Answer& exact);
/// The farthest hit alone in place of the nearest.
[[nodiscard]] Answers farthest_alone(const Case& one, const Answer& exact);
/// One of two hits or roots is left out: the second.
[[nodiscard]] Answers first_alone(const Case& one, const Answer& exact);
/// @{ One of two hits or roots is given twice, the nearest or the farthest, and the other is not.
[[nodiscard]] Answers nearest_twice(const Case& one, const Answer& exact);
[[nodiscard]] Answers farthest_twice(const Case& one, const Answer& exact);
/// @}
/// One of two roots is given, the smaller or the greater one, whatever it is called.
[[nodiscard]] Answers root_alone(const Case& one, const Answer& exact);
/// Two equal hits, or roots, where there is one double one.
[[nodiscard]] Answers double_hit_twice(const Case& one, const Answer& exact);
/// One crossing in the interval is reported twice.
[[nodiscard]] Answers single_hit_twice(const Case& one, const Answer& exact);

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
/// A ray that runs inside a plane is called parallel.
[[nodiscard]] Answers in_surface_is_parallel(const Case& one, const Answer& exact);
/// The reason why a ray misses is not given.
[[nodiscard]] Answers no_reason(const Case& one, const Answer& exact);
/// A number of the answer is infinite, in ordinary numbers, and none should be.
[[nodiscard]] std::optional<bool> is_infinite(const Case& one, const Answer& got, const Answer& exact);
/// The line's hits are all given at t = 0, if the interval admits that.
[[nodiscard]] Answers all_at_zero(const Case& one, const Answer& exact);
/// Every t of the answer is 0, and none should be.
[[nodiscard]] std::optional<bool> is_all_zero(const Case& one, const Answer& got, const Answer& exact);
/// A number that is no number, or infinite.
[[nodiscard]] std::optional<bool> is_nan(const Case& one, const Answer& got, const Answer& exact);

}  // namespace rayproof::diagnosis
