#pragma once
/// \file
/// A ray and a plane, exactly: what the oracles for planes, triangles and polygons share.

#include "case/answer.hpp"
#include "oracle/geometry/hit.hpp"

namespace rayproof::oracle {

/// The plane normal·q = offset in the object's space.
struct FlatEquation {
  Vector<Ring> normal;
  Ring offset;
};

/// The ray's line put into the plane's equation: slope·t = gap, in the scale of ObjectRay.
struct FlatMeeting {
  Ring gap;
  Ring slope;

  FlatMeeting(const ObjectRay<Ring>& ray, const FlatEquation& plane)
      : gap(ray.scale * plane.offset - dot(plane.normal, ray.origin)),
        slope(dot(plane.normal, ray.direction)) {}

  [[nodiscard]] bool is_parallel() const { return sign(slope) == 0; }
  /// Why a line that is parallel to the plane misses it.
  [[nodiscard]] Contact parallel_contact() const {
    return sign(gap) == 0 ? Contact::in_surface : Contact::parallel;
  }
  [[nodiscard]] Quotient t() const { return {gap, slope}; }
};

/// The answer of a hit at t, with its point and the figure's normal.
[[nodiscard]] RayAnswer flat_answer(const RayQuestion& question, const ObjectRay<Ring>& ray,
                                    const Vector<Ring>& normal, const Quotient& t, Contact contact,
                                    Precision precision);

}  // namespace rayproof::oracle
