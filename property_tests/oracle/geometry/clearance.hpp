#pragma once
/// \file
/// How far a ray passes from points and segments.

#include "oracle/geometry/scene.hpp"
#include "oracle/numbers/exact.hpp"

namespace rayproof::oracle {

[[nodiscard]] inline Vector<Scaled> approximate(const Vector<Ring>& v) {
  return {approximate(v.x), approximate(v.y), approximate(v.z)};
}

/// The part of a line that a ray's interval leaves. All points are seen from the ray's origin, in the scale
/// of ObjectRay.
struct RayPart {
  Vector<Scaled> direction;
  double t_min, t_max;
  Scaled origin_reach, direction_reach;  ///< a length at t is measured in origin_reach + |t|·direction_reach

  /// The least distance of the part from a point, in units of the reach where it is nearest.
  [[nodiscard]] Scaled distance_to(const Vector<Scaled>& point) const;
  /// The same from a segment.
  [[nodiscard]] Scaled distance_to(const Vector<Scaled>& from, const Vector<Scaled>& to) const;

 private:
  [[nodiscard]] Scaled in_units(const Vector<Scaled>& apart, const Scaled& t) const;
};

}  // namespace rayproof::oracle
