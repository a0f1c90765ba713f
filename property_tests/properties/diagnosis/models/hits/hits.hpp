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
/// The root of -√D before that of +√D: where a < 0 that is the descending order.
[[nodiscard]] Answers minus_root_first(const Case& one, const Answer& exact);
/// The farthest hit alone in place of the nearest.
[[nodiscard]] Answers farthest_alone(const Case& one, const Answer& exact);
/// Of the hits in the interval the one of the smallest |t| alone, in place of the nearest.
[[nodiscard]] Answers smallest_alone(const Case& one, const Answer& exact);
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
/// The same of every solid that is met at one t alone, be it touched or without thickness there.
[[nodiscard]] Answers entry_and_exit_at_one_t(const Case& one, const Answer& exact);
/// One crossing in the interval is reported twice.
[[nodiscard]] Answers single_hit_twice(const Case& one, const Answer& exact);

}  // namespace rayproof::diagnosis
