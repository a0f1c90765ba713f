#include "oracle/geometry/locate.hpp"

#include <algorithm>

namespace rayproof::oracle {

Scaled distance_to_side(const PlanePoint<Ring>& point, const Ring& weight, const PlanePoint<Ring>& from,
                        const PlanePoint<Ring>& to) {
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
