#pragma once
/// \file
/// The three pairs of parallel planes of a convex solid and a line, exactly: what box and parallelepiped
/// share.

#include <array>

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
        low(ray.scaled(lower)),
        high(ray.scaled(upper)) {}

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

[[nodiscard]] inline SlabMeetings meetings(const ObjectRay<Ring>& ray, const Box<double>& box) {
  const auto slab = [&](int axis) {
    glm::dvec3 normal(0);
    normal[axis] = 1;
    return SlabMeeting(ray, Vector<Ring>::from(normal), Ring(box.min[axis]), Ring(box.max[axis]));
  };
  return {slab(0), slab(1), slab(2)};
}

[[nodiscard]] inline SlabMeetings meetings(const ObjectRay<Ring>& ray, const Parallelepiped<double>& solid) {
  const auto corner = Vector<Ring>::from(solid.corner);
  const auto edge = [&](std::size_t i) { return Vector<Ring>::from(solid.edges[i % 3]); };
  const auto slab = [&](std::size_t i) {
    Vector<Ring> normal = cross(edge(i + 1), edge(i + 2));
    if (sign(dot(normal, edge(i))) < 0) normal = -normal;
    const Ring low = dot(normal, corner);
    return SlabMeeting(ray, normal, low, low + dot(normal, edge(i)));
  };
  return {slab(0), slab(1), slab(2)};
}

}  // namespace rayproof::oracle
