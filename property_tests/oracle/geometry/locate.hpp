#pragma once
/// \file
/// Where a point of the plane lies with respect to a polygon, exactly, by the even-odd rule.

#include <vector>

#include "case/answer.hpp"
#include "oracle/numbers/exact.hpp"

namespace rayproof::oracle {

/// A point of the plane over the exact ring.
struct PlanePoint {
  Ring x, y;
};

/// How the point (x, y)/weight, weight > 0, touches the closed polygon of the vertices: `crossing` inside,
/// `edge` or `vertex` on the boundary, `none` outside.
[[nodiscard]] Contact locate(const PlanePoint& point, const Ring& weight,
                             const std::vector<PlanePoint>& vertices);

/// The distance of the point from the side, all to one part in 2^50.
[[nodiscard]] Scaled distance_to_side(const PlanePoint& point, const Ring& weight, const PlanePoint& from,
                                      const PlanePoint& to);

}  // namespace rayproof::oracle
