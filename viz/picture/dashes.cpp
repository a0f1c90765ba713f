#include "viz/picture/dashes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rayproof::viz {

std::vector<std::vector<Point>> dashes_of(const PixelLine& line) {
  if (line.pattern == Pattern::solid) return {line.points};
  const double on = line.pattern == Pattern::dashed ? 7 : 1.5;
  const double off = 5;
  std::vector<std::vector<Point>> dashes;
  double walked = 0;  // along the pattern, within [0, on + off)
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    const Point& a = line.points[i];
    const Point& b = line.points[i + 1];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const auto at = [&](double s) {
      return Point{a.x + (b.x - a.x) * s / length, a.y + (b.y - a.y) * s / length};
    };
    for (double s = 0; s < length;) {
      const bool is_on = walked < on;
      const double rest = std::min((is_on ? on : on + off) - walked, length - s);
      if (is_on) dashes.push_back({at(s), at(s + rest)});
      s += rest;
      walked += rest;
      if (walked >= on + off - 1e-9) walked = 0;
    }
  }
  return dashes;
}

}  // namespace rayproof::viz
