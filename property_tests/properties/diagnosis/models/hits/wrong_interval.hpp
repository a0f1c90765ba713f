#pragma once
/// \file
/// Models of faults in how hits are compared with the ray's interval.

#include <algorithm>
#include <cmath>

#include "properties/diagnosis/models/models.hpp"

namespace rayproof::diagnosis {

/// Both hits of a line must lie in the interval, and the farther one is given.
[[nodiscard]] Answers farther_of_both(const Case& one, const Answer& exact);
/// t > t_max is asked, beside t > t_min: the last comparison is the wrong way round.
[[nodiscard]] Answers beyond_both_ends(const Case& one, const Answer& exact);
/// Whether something is found so.
[[nodiscard]] bool has_hit_beyond_both(const Case& one, const Answer& exact);
/// Of two hits the one of the smaller |t| is given alone, without its sign, unless both lie behind the
/// origin.
[[nodiscard]] Answers smaller_without_sign(const Case& one, const Answer& exact);

/// @{ The interval is read otherwise: |t_min| for t_min; 0 for an infinite t_max, or for either infinite end;
/// t_max - t_min for t_max.
[[nodiscard]] Answers absolute_t_min(const Case& one, const Answer& exact);
[[nodiscard]] Answers infinity_as_zero(const Case& one, const Answer& exact);
[[nodiscard]] std::vector<Case> t_max_as_length(const Case& one);
/// @}
/// The interval begins at -10^power, whatever t_min.
[[nodiscard]] Answers begins_at(const Case& one, double t_min);
template <int power>
[[nodiscard]] Answers begins_behind(const Case& one, const Answer& /*exact*/) {
  return begins_at(one, -std::pow(10.0, power));
}
/// Whether a hit is given so that lies behind the origin and before t_min.
template <int power>
[[nodiscard]] bool has_hit_behind(const Case& one, const Answer& exact) {
  const double beginning = std::min(0.0, ray_question(one)->ray.t_min);
  return std::ranges::any_of(begins_behind<power>(one, exact), [&](const Answer& answer) {
    const HitList& hits = std::get<RayAnswer>(answer).hits;
    return hits.count > 0 && hits.t[0] < beginning;
  });
}

/// The slabs of a solid begin with the interval [-end, end] in place of the whole line: what lies beyond is
/// cut off there, or missed.
[[nodiscard]] Answers cut_at(const Case& one, double end);
template <int power>
[[nodiscard]] Answers cut_at(const Case& one, const Answer& /*exact*/) {
  return cut_at(one, std::pow(10.0, power));
}
/// Whether a hit is given so where the solid is cut off.
template <int power>
[[nodiscard]] bool has_hit_on_cut(const Case& one, const Answer& exact) {
  const double end = std::pow(10.0, power);
  return std::ranges::any_of(cut_at<power>(one, exact), [&](const Answer& answer) {
    return std::ranges::any_of(std::get<RayAnswer>(answer).hits.view(),
                               [&](double t) { return std::abs(t) == end; });
  });
}

/// Every t is less, or greater, by 10^power.
[[nodiscard]] Answers offset_by(const Answer& exact, double length);
template <int power>
[[nodiscard]] Answers offset_by(const Case& /*one*/, const Answer& exact) {
  return offset_by(exact, std::pow(10.0, power));
}

}  // namespace rayproof::diagnosis
