#include "oracle/geometry/clearance.hpp"

#include <algorithm>

#include "oracle/geometry/sizes.hpp"
#include "oracle/numbers/quotient.hpp"

namespace rayproof::oracle {
namespace {

/// The distance of a point from the line through 0 along a vector, times the vector's length.
Scaled off_line(const Vector<Ring>& point, const Vector<Ring>& along) { return norm(cross(point, along)); }

}  // namespace

Scaled RayPart::in_units(const Scaled& numerator, const Scaled& denominator, const Scaled& t) const {
  return ratio(numerator, denominator * approximate(weight) * (origin_reach + abs(t) * direction_reach));
}

Scaled RayPart::distance_to(const Vector<Ring>& point) const {
  const Quotient nearest(dot(point, direction), weight * dot(direction, direction));
  for (const auto& [end, side] : {std::pair{t_min, -1}, std::pair{t_max, 1}})
    if (std::isfinite(end) && nearest.compare(Ring(end)) * side > 0)
      return in_units(norm(point - point_at(end)), Scaled(1), Scaled(end));
  return in_units(off_line(point, direction), norm(direction), nearest.estimate());
}

Scaled RayPart::distance_to(const Vector<Ring>& from, const Vector<Ring>& to) const {
  Scaled nearest = std::min(distance_to(from), distance_to(to));
  const Vector<Ring> along = to - from, across = cross(direction, along);
  const Ring length = dot(along, along), area = dot(across, across);
  for (const double end : {t_min, t_max}) {
    if (!std::isfinite(end) || sign(length) == 0) continue;
    const Vector<Ring> seen = point_at(end) - from;
    const Ring place = dot(seen, along);
    if (sign(place) >= 0 && sign(length - place) >= 0)
      nearest = std::min(nearest, in_units(off_line(seen, along), norm(along), Scaled(end)));
  }
  if (sign(area) == 0) return nearest;
  // The two lines are nearest where weight·t·direction = from + s·along + w·across.
  const Quotient t(dot(cross(from, along), across), weight * area);
  const Ring s = dot(cross(from, direction), across);
  const bool is_on_segment = sign(s) >= 0 && sign(area - s) >= 0;
  const bool is_before = std::isfinite(t_min) && t.compare(Ring(t_min)) < 0;
  const bool is_behind = std::isfinite(t_max) && t.compare(Ring(t_max)) > 0;
  if (!is_on_segment || is_before || is_behind) return nearest;
  return std::min(nearest, in_units(abs(approximate(dot(from, across))), norm(across), t.estimate()));
}

}  // namespace rayproof::oracle
