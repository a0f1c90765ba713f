#include <algorithm>
#include <cmath>

#include "oracle/geometry/newell.hpp"
#include "viz/render/figures/make_figures.hpp"

namespace rayproof::render {
namespace {

/// How high the plane of a polygon may rise from its first vertex over the others' distance along two axes,
/// if the third, `axis`, is the one that its projection drops; 0 where it is certainly not that one.
double rise_of(const std::array<Interval, 3>& normal, int axis, const glm::dvec3& reach) {
  constexpr double outwards = 1 + 0x1p-40;  // outweighs the roundings of these lines
  const auto at_most = [&](int i) {
    const Interval& n = normal[static_cast<std::size_t>(i)];
    return outwards * (std::abs(n.middle) + n.radius);
  };
  const auto at_least = [&](int i) {
    const Interval& n = normal[static_cast<std::size_t>(i)];
    return std::max(0.0, std::abs(n.middle) / outwards - outwards * n.radius);
  };
  const int x = (axis + 1) % 3, y = (axis + 2) % 3;
  if (at_most(axis) < std::max(at_least(x), at_least(y))) return 0;
  const auto over = [&](int other) {
    const double slope = at_least(axis) > 0 ? std::min(1.0, at_most(other) / at_least(axis)) : 1;
    return outwards * slope * reach[other];
  };
  return outwards * (over(x) + over(y));
}

/// A polygon lies in its exact plane through the first vertex, from which the others may stand off: along the
/// axis that its projection drops, the box is as high as the plane rises over the other two.
void enclose(Hull& hull, const Polygon<double>& polygon) {
  const glm::dvec3 first = polygon.vertices.front();
  Bounds box{first, first};
  for (const glm::dvec3& vertex : polygon.vertices) box = box.around({vertex, vertex});
  const glm::dvec3 reach = glm::max(first - box.low, box.high - first);
  const auto normal = coordinates_of(oracle::newell_normal<Interval>(polygon));
  for (int axis = 0; axis < 3; ++axis) {
    const Interval from(first[axis]), rise(rise_of(normal, axis, reach));
    box.low[axis] = std::min(box.low[axis], below(from - rise));
    box.high[axis] = std::max(box.high[axis], above(from + rise));
  }
  hull.add_box(Point::from(box.low), Point::from(box.high));
}

}  // namespace

FigureKind polygon_figures() { return figure_kind<polygon::Topic, Polygon<double>, enclose>(); }

}  // namespace rayproof::render
