#include "viz/render/figures/hull.hpp"

#include <algorithm>

namespace rayproof::render {

double below(const Interval& x) { return std::nextafter(x.middle - x.radius, -HUGE_VAL); }
double above(const Interval& x) { return std::nextafter(x.middle + x.radius, HUGE_VAL); }

void Hull::add(const Point& p) {
  int axis = 0;
  for (const Interval& x : coordinates_of(transform_ ? image(p) : p)) {
    bounds_.low[axis] = std::min(bounds_.low[axis], below(x));
    bounds_.high[axis] = std::max(bounds_.high[axis], above(x));
    // Also false for NaN.
    is_sound_ = is_sound_ && below(x) > -largest_sound && above(x) < largest_sound;
    ++axis;
  }
}

void Hull::add_box(const Point& low, const Point& high) {
  for (unsigned corner = 0; corner < 8; ++corner) {
    add(Point{(corner & 1U) != 0 ? high.x : low.x, (corner & 2U) != 0 ? high.y : low.y,
              (corner & 4U) != 0 ? high.z : low.z});
  }
}

Point Hull::image(const Point& p) const {
  const glm::dmat4& m = *transform_;
  return p.x * Point::from(m[0]) + p.y * Point::from(m[1]) + p.z * Point::from(m[2]) + Point::from(m[3]);
}

}  // namespace rayproof::render
