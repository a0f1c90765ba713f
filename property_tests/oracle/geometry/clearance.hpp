#pragma once
/// \file
/// How far a ray passes from points and segments.
///
/// Distances are taken from exact products: of a segment that the ray runs along for long, rounded ones would
/// leave nothing.

#include "oracle/geometry/scene.hpp"
#include "oracle/numbers/exact.hpp"

namespace rayproof::oracle {

/// The part of a line that a ray's interval leaves. All points are seen from the ray's origin, in the scale
/// of ObjectRay, times `weight`.
struct RayPart {
  Vector<Ring> direction;
  double t_min, t_max;
  Scaled origin_reach, direction_reach;  ///< a length at t is measured in origin_reach + |t|·direction_reach
  Ring weight{1.0};                      ///< positive

  /// The least distance of the part from a point, in units of the reach where it is nearest.
  [[nodiscard]] Scaled distance_to(const Vector<Ring>& point) const;
  /// The same from a segment.
  [[nodiscard]] Scaled distance_to(const Vector<Ring>& from, const Vector<Ring>& to) const;

 private:
  /// p(t) as points are given.
  [[nodiscard]] Vector<Ring> point_at(double t) const { return (weight * Ring(t)) * direction; }
  /// numerator/denominator, a distance times the weight, in units of the reach at t.
  [[nodiscard]] Scaled in_units(const Scaled& numerator, const Scaled& denominator, const Scaled& t) const;
};

}  // namespace rayproof::oracle
