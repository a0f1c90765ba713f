#include "viz/drawing/even_odd.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "viz/drawing/clip.hpp"

namespace rayproof::viz {
namespace {

/// A side of the polygon that is not level, from its upper to its lower end.
struct Slope {
  Point upper, lower;
  [[nodiscard]] double at(double y) const {
    return upper.x + (lower.x - upper.x) * std::clamp((y - upper.y) / (lower.y - upper.y), 0.0, 1.0);
  }
};

std::vector<Slope> slopes_of(const std::vector<Point>& ring) {
  std::vector<Slope> slopes;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = ring[(i + 1) % ring.size()];
    if (a.y < b.y) slopes.push_back({a, b});
    if (b.y < a.y) slopes.push_back({b, a});
  }
  return slopes;
}

/// The rows at which the order of the sides may change: at their ends, and where two of them cross.
std::set<double> rows_of(const std::vector<Slope>& slopes) {
  std::set<double> rows;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    rows.insert({std::round(slopes[i].upper.y), std::round(slopes[i].lower.y)});
    for (std::size_t j = 0; j < i; ++j) {
      const double top = std::max(slopes[i].upper.y, slopes[j].upper.y);
      const double bottom = std::min(slopes[i].lower.y, slopes[j].lower.y);
      const double before = slopes[i].at(top) - slopes[j].at(top);
      const double after = slopes[i].at(bottom) - slopes[j].at(bottom);
      if (top < bottom && (before < 0) != (after < 0) && before != after)
        rows.insert(std::round(top + (bottom - top) * before / (before - after)));
    }
  }
  return rows;
}

}  // namespace

void draw_even_odd(Picture& picture, const View& view, Role role, const std::vector<WorldPoint>& points) {
  std::vector<Point> ring;
  for (const WorldPoint& p : clip_area_near(points, view)) ring.push_back(view.to_pixels(p));
  const std::vector<Slope> slopes = slopes_of(clip_area(std::move(ring), view.frame));
  const std::set<double> rows = rows_of(slopes);
  if (rows.empty()) return;
  for (auto row = rows.begin(); std::next(row) != rows.end(); ++row) {
    const double top = *row;
    const double bottom = *std::next(row);
    const double middle = (top + bottom) / 2;
    std::vector<const Slope*> across;
    for (const Slope& slope : slopes) {
      if (slope.upper.y <= middle && middle < slope.lower.y) across.push_back(&slope);
    }
    std::sort(across.begin(), across.end(),
              [&](const Slope* a, const Slope* b) { return a->at(middle) < b->at(middle); });
    for (std::size_t i = 0; i + 1 < across.size(); i += 2) {
      const Slope& left = *across[i];
      const Slope& right = *across[i + 1];
      picture.elements.emplace_back(Area{role,
                                         {{left.at(top), top},
                                          {right.at(top), top},
                                          {right.at(bottom), bottom},
                                          {left.at(bottom), bottom}}});
    }
  }
}

}  // namespace rayproof::viz
