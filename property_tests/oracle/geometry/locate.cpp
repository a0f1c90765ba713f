#include "oracle/geometry/locate.hpp"

#include <algorithm>
#include <utility>

namespace rayproof::oracle {
Contact locate(const PlanePoint& point, const Ring& weight, const std::vector<PlanePoint>& vertices) {
  const auto seen = [&](const PlanePoint& vertex) {  // from the point, times the weight
    return PlanePoint{weight * vertex.x - point.x, weight * vertex.y - point.y};
  };
  bool is_on_side = false;
  bool is_inside = false;
  PlanePoint from = seen(vertices.back());
  for (const PlanePoint& vertex : vertices) {
    PlanePoint to = seen(vertex);
    const int start = sign(from.y), end = sign(to.y);
    if (end == 0 && sign(to.x) == 0) return Contact::vertex;
    if (start == 0 && end == 0) {
      is_on_side = is_on_side || sign(from.x) * sign(to.x) <= 0;
    } else if (start * end <= 0) {
      // The signed area seen from the point: positive where the side passes it on the right, going up.
      const int area = sign(from.x * to.y - from.y * to.x);
      is_on_side = is_on_side || area == 0;
      // Each side holds its lower end, not its upper one, so that a vertex that is passed counts once.
      const bool passes = (start > 0) != (end > 0);
      is_inside = is_inside != (passes && (area > 0) == (end > 0));
    }
    from = std::move(to);
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
