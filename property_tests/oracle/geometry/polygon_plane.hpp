#pragma once
/// \file
/// The plane and the projection of a polygon in space, exactly.

#include "oracle/geometry/flat.hpp"
#include "oracle/geometry/locate.hpp"

namespace rayproof::oracle {

/// The plane through the first vertex with the Newell normal; a zero normal where the area is zero.
[[nodiscard]] FlatEquation plane_of(const Polygon<double>& polygon);

/// The coordinates that are left where the axis of the normal's largest component is dropped (ties: the later
/// axis).
struct Projection {
  int x = 0, y = 1;

  explicit Projection(const Vector<Ring>& normal);

  [[nodiscard]] PlanePoint operator()(const Vector<Ring>& v) const { return {pick(v, x), pick(v, y)}; }

 private:
  static const Ring& pick(const Vector<Ring>& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
};

/// The vertices in the projection.
[[nodiscard]] std::vector<PlanePoint> projected(const Polygon<double>& polygon, const Projection& projection);

}  // namespace rayproof::oracle
