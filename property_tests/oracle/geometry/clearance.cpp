#include "oracle/geometry/clearance.hpp"

#include <algorithm>

#include "oracle/geometry/sizes.hpp"

namespace rayproof::oracle {

Scaled RayPart::in_units(const Vector<Scaled>& apart, const Scaled& t) const {
  return ratio(norm(apart), origin_reach + abs(t) * direction_reach);
}

Scaled RayPart::distance_to(const Vector<Scaled>& point) const {
  Scaled t = dot(point, direction) / squared_norm(direction);
  if (std::isfinite(t_min)) t = std::max(t, Scaled(t_min));
  if (std::isfinite(t_max)) t = std::min(t, Scaled(t_max));
  return in_units(point - t * direction, t);
}

Scaled RayPart::distance_to(const Vector<Scaled>& from, const Vector<Scaled>& to) const {
  Scaled nearest = std::min(distance_to(from), distance_to(to));
  const Vector<Scaled> along = to - from, across = cross(direction, along);
  for (const double end : {t_min, t_max}) {
    if (!std::isfinite(end) || squared_norm(along).sign() == 0) continue;
    const Vector<Scaled> seen = Scaled(end) * direction - from;
    const Scaled s = std::clamp(dot(seen, along) / squared_norm(along), Scaled(0), Scaled(1));
    nearest = std::min(nearest, in_units(seen - s * along, Scaled(end)));
  }
  const Scaled area = squared_norm(across);
  if (area.sign() == 0) return nearest;
  // The two lines are nearest where t·direction = from + s·along + w·across.
  const Scaled t = dot(cross(from, along), across) / area, s = dot(cross(from, direction), across) / area;
  const bool is_on_segment = s.sign() >= 0 && (s - Scaled(1)).sign() <= 0;
  const bool is_before = std::isfinite(t_min) && t < Scaled(t_min);
  const bool is_behind = std::isfinite(t_max) && Scaled(t_max) < t;
  if (!is_on_segment || is_before || is_behind) return nearest;
  return std::min(nearest, in_units((dot(from, across) / area) * across, t));
}

}  // namespace rayproof::oracle
