#include "oracle/geometry/locate.hpp"

#include <algorithm>

namespace rayproof::oracle {
namespace {

/// A vertex as seen from the point, both times the weight, and the sign of how far it lies above.
struct SeenVertex {
  PlanePoint to;
  int above;
};

/// What one side says: the point lies on it, or a ray to the right crosses it, or neither.
struct CrossedSide {
  bool holds_point;
  bool is_crossed;
};

CrossedSide side_of(const SeenVertex& from, const SeenVertex& to) {
  if (from.above == 0 && to.above == 0) return {sign(from.to.x) * sign(to.to.x) <= 0, false};
  if (from.above * to.above > 0) return {false, false};
  // The signed area seen from the point: positive where the side passes it on the right, going up.
  const int area = sign(from.to.x * to.to.y - from.to.y * to.to.x);
  if (area == 0) return {true, false};
  // Each side holds its lower end, not its upper one, so that a vertex that is passed counts once.
  const bool goes_up = from.above <= 0 && to.above > 0;
  const bool goes_down = to.above <= 0 && from.above > 0;
  return {false, (goes_up && area > 0) || (goes_down && area < 0)};
}

}  // namespace

Contact locate(const PlanePoint& point, const Ring& weight, const std::vector<PlanePoint>& vertices) {
  const auto seen = [&](const PlanePoint& vertex) {
    const PlanePoint to{weight * vertex.x - point.x, weight * vertex.y - point.y};
    return SeenVertex{to, sign(to.y)};
  };
  bool is_on_side = false;
  bool is_inside = false;
  SeenVertex from = seen(vertices.back());
  for (const PlanePoint& vertex : vertices) {
    const SeenVertex to = seen(vertex);
    if (to.above == 0 && sign(to.to.x) == 0) return Contact::vertex;
    const CrossedSide side = side_of(from, to);
    is_on_side = is_on_side || side.holds_point;
    is_inside = is_inside != side.is_crossed;
    from = to;
  }
  if (is_on_side) return Contact::edge;
  return is_inside ? Contact::crossing : Contact::none;
}

Scaled distance_to_side(const PlanePoint& point, const Ring& weight, const PlanePoint& from,
                        const PlanePoint& to) {
  const Scaled x = approximate(point.x - weight * from.x), y = approximate(point.y - weight * from.y);
  const Scaled along_x = approximate(to.x - from.x), along_y = approximate(to.y - from.y);
  const Scaled scale = approximate(weight);
  const Scaled squared = along_x * along_x + along_y * along_y;
  const Scaled share = squared.sign() == 0
                           ? Scaled{}
                           : std::clamp((x * along_x + y * along_y) / (squared * scale), Scaled{}, Scaled(1));
  const Scaled dx = x / scale - share * along_x, dy = y / scale - share * along_y;
  return sqrt(dx * dx + dy * dy);
}

}  // namespace rayproof::oracle
