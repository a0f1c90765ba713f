#pragma once
/// \file
/// Models of faults with the ray's interval of t.

#include <cmath>

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// @{ Readings of the case: the interval has no upper end, no lower one, neither; begins at 0; is [0, inf];
/// is a segment's; is meant in units of length, in the world or in the object's space, or its upper end is.
[[nodiscard]] std::vector<Case> without_t_max(const Case& one);
[[nodiscard]] std::vector<Case> without_t_min(const Case& one);
[[nodiscard]] std::vector<Case> without_interval(const Case& one);
[[nodiscard]] std::vector<Case> from_origin_on(const Case& one);
[[nodiscard]] std::vector<Case> as_segment(const Case& one);
[[nodiscard]] std::vector<Case> interval_as_distances(const Case& one);
[[nodiscard]] std::vector<Case> t_max_as_distance(const Case& one);
[[nodiscard]] std::vector<Case> interval_as_object_distances(const Case& one);
[[nodiscard]] std::vector<Case> t_max_as_object_distance(const Case& one);
/// @}

/// The interval begins at 0.
[[nodiscard]] Answers t_min_is_zero(const Case& one, const Answer& exact);
/// The same where t_min is negative alone.
[[nodiscard]] Answers t_min_cut_to_zero(const Case& one, const Answer& exact);
/// t_min is taken for t_max, too: the interval is [0, t_min].
[[nodiscard]] Answers t_min_as_t_max(const Case& one, const Answer& exact);
/// Whether a hit is given so, and not only missed.
[[nodiscard]] bool has_hit_before_t_min(const Case& one, const Answer& exact);
/// t is counted from t_min.
[[nodiscard]] Answers t_from_t_min(const Case& one, const Answer& exact);
/// Of an interval that ends at 0 the end is not looked at.
[[nodiscard]] Answers t_squared_to_t_max(const Case& one, const Answer& exact);
[[nodiscard]] Answers zero_as_no_end(const Case& one, const Answer& exact);

/// The exact hits without those that are dropped; nothing where none is.
[[nodiscard]] Answers drops(const Case& one, const Answer& exact, bool (*is_dropped)(double t));

/// @{ A hit that lies exactly on an end of the interval is left out.
[[nodiscard]] Answers open_at_t_min(const Case& one, const Answer& exact);
[[nodiscard]] Answers open_at_t_max(const Case& one, const Answer& exact);
[[nodiscard]] Answers open_at_both_ends(const Case& one, const Answer& exact);
/// @}
/// A hit exactly at the ray's origin is left out, wherever the interval begins.
[[nodiscard]] Answers open_at_zero(const Case& one, const Answer& exact);
/// @{ The same of a ray that enters there, or leaves a solid there, alone.
[[nodiscard]] Answers open_where_entering(const Case& one, const Answer& exact);
[[nodiscard]] Answers open_where_leaving(const Case& one, const Answer& exact);
/// @}
/// A hit before t_min is reported, rightly computed or not.
[[nodiscard]] std::optional<bool> hits_before_t_min(const Case& one, const Answer& got, const Answer& exact);

/// Whether the first hit lies before the ray's origin, and not on t_min; or at t < 0.
[[nodiscard]] bool has_first_hit_before_origin(const Case& one, const Answer& exact);
[[nodiscard]] bool has_first_hit_behind_origin(const Case& one, const Answer& exact);
/// Hits of t below 10^power, which the interval admits, are left out.
template <int power>
[[nodiscard]] Answers drops_below(const Case& one, const Answer& exact) {
  return drops(one, exact, [](double t) { return t < std::pow(10.0, power); });
}
/// Hits of t that is not positive are left out, wherever the interval begins.
[[nodiscard]] inline Answers drops_not_positive(const Case& one, const Answer& exact) {
  return drops(one, exact, [](double t) { return !(t > 0); });
}
/// Hits of t below the machine epsilon of the case's precision, which the interval admits, are left out; and
/// those of a distance below it, as a program has it that makes the direction a unit vector.
[[nodiscard]] Answers drops_below_epsilon(const Case& one, const Answer& exact);
/// Hits of t beyond 10^power, which the interval admits, are left out.
template <int power>
[[nodiscard]] Answers drops_beyond(const Case& one, const Answer& exact) {
  return drops(one, exact, [](double t) { return t > std::pow(10.0, power); });
}

}  // namespace rayproof::diagnosis
