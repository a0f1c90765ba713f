#pragma once
/// \file
/// A convex solid between three pairs of parallel planes and a line, exactly: what box and parallelepiped
/// share.

#include <array>
#include <optional>

#include "oracle/geometry/scene.hpp"
#include "oracle/numbers/quotient.hpp"

namespace rayproof::oracle {

/// A line and a slab, all q with low <= normal·q <= high: low <= position + t·speed <= high in the scale of
/// ObjectRay.
struct SlabMeeting {
  Vector<Ring> normal;  ///< in the object's space
  Ring position, speed, low, high;

  SlabMeeting(const ObjectRay<Ring>& ray, const Vector<Ring>& n, const Ring& lower, const Ring& upper)
      : normal(n),
        position(dot(n, ray.origin)),
        speed(dot(n, ray.direction)),
        low(ray.scale * lower),
        high(ray.scale * upper) {}

  [[nodiscard]] bool is_parallel() const { return sign(speed) == 0; }
  /// Whether a line that is parallel to the slab runs in it.
  [[nodiscard]] bool is_inside() const { return sign(position - low) >= 0 && sign(high - position) >= 0; }
  /// The t at which the line comes into the slab, and at which it leaves.
  [[nodiscard]] Quotient entry() const { return {(sign(speed) > 0 ? low : high) - position, speed}; }
  [[nodiscard]] Quotient exit() const { return {(sign(speed) > 0 ? high : low) - position, speed}; }
  /// position + t·speed - bound, times the denominator of t.
  [[nodiscard]] Ring beyond(const Ring& bound, const Quotient& t) const {
    return (position - bound) * t.denominator() + speed * t.numerator();
  }
};
using SlabMeetings = std::array<SlabMeeting, 3>;

[[nodiscard]] SlabMeetings meetings(const ObjectRay<Ring>& ray, const Box<double>& box);
[[nodiscard]] SlabMeetings meetings(const ObjectRay<Ring>& ray, const Parallelepiped<double>& solid);

/// The part of the line inside the solid, from entry to exit; nothing where there is none.
struct Chord {
  Quotient entry, exit;
  [[nodiscard]] bool is_touch() const { return entry.compare(exit) == 0; }
};
[[nodiscard]] std::optional<Chord> chord_of(const SlabMeetings& slabs);

}  // namespace rayproof::oracle
