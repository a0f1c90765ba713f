#pragma once
/// \file
/// Where a point of the plane lies with respect to a polygon, exactly, by the even-odd rule.

#include <utility>

#include "case/answer.hpp"
#include "oracle/numbers/exact.hpp"

namespace rayproof::oracle {

/// A point of the plane over R: the exact ring, or estimates.
template <class R>
struct PlanePoint {
  R x, y;
};

/// How the point (x, y)/weight, weight > 0, touches the closed polygon of the vertices, each of which
/// `in_plane` makes a PlanePoint: `crossing` inside, `edge` or `vertex` on the boundary, `none` outside.
/// Notes a doubt of estimates that are not enough.
template <class R, class Vertices, class InPlane>
[[nodiscard]] Contact locate(const PlanePoint<R>& point, const R& weight, const Vertices& vertices,
                             const InPlane& in_plane) {
  // A vertex as seen from the point, times the weight. Few sides need more than the y of their ends.
  const auto seen_x = [&](const PlanePoint<R>& vertex) { return weight * vertex.x - point.x; };
  const auto seen_y = [&](const PlanePoint<R>& vertex) { return weight * vertex.y - point.y; };
  bool is_on_side = false;
  bool is_inside = false;
  PlanePoint<R> from = in_plane(vertices.back());
  R from_y = seen_y(from);
  int start = sign(from_y);
  for (const auto& vertex : vertices) {
    const PlanePoint<R> to = in_plane(vertex);
    R to_y = seen_y(to);
    const int end = sign(to_y);
    if (end == 0 && sign(seen_x(to)) == 0) return Contact::vertex;
    if (start == 0 && end == 0) {
      is_on_side = is_on_side || sign(seen_x(from)) * sign(seen_x(to)) <= 0;
    } else if (start * end <= 0) {
      // The signed area seen from the point: positive where the side passes it on the right, going up.
      const int area = sign(seen_x(from) * to_y - from_y * seen_x(to));
      is_on_side = is_on_side || area == 0;
      // Each side holds its lower end, not its upper one, so that a vertex that is passed counts once.
      const bool passes = (start > 0) != (end > 0);
      is_inside = is_inside != (passes && (area > 0) == (end > 0));
    }
    from = to;
    from_y = std::move(to_y);
    start = end;
  }
  if (is_on_side) return Contact::edge;
  return is_inside ? Contact::crossing : Contact::none;
}

/// The distance of the point from the side, all to one part in 2^50.
[[nodiscard]] Scaled distance_to_side(const PlanePoint<Ring>& point, const Ring& weight,
                                      const PlanePoint<Ring>& from, const PlanePoint<Ring>& to);

}  // namespace rayproof::oracle
