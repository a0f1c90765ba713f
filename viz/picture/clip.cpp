#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>

#include "viz/picture/picture.hpp"

namespace rayproof::viz {
namespace {

/// A side of a box as the half-plane nx·x + ny·y <= limit.
struct HalfPlane {
  int nx, ny;
  double limit;
  [[nodiscard]] double outside(const Point& p) const { return nx * p.x + ny * p.y - limit; }
};

std::array<HalfPlane, 4> sides_of(const PixelBox& box) {
  return {{{-1, 0, -box.left}, {1, 0, box.right()}, {0, -1, -box.top}, {0, 1, box.bottom()}}};
}

Point into(const Point& p, const PixelBox& box) {
  return {std::clamp(p.x, box.left, box.right()), std::clamp(p.y, box.top, box.bottom())};
}

Point mix(const Point& a, const Point& b, double s) { return {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)}; }

/// The part [enter, leave] of the segment inside the sides (Liang and Barsky); empty where enter > leave, or
/// where an end is at no finite place.
std::array<double, 2> inside(const Point& a, const Point& b, const std::array<HalfPlane, 4>& sides) {
  double enter = 0;
  double leave = 1;
  for (const HalfPlane& side : sides) {
    const double from = side.outside(a);
    const double to = side.outside(b);
    if (!std::isfinite(from - to) || (from > 0 && to > 0)) return {1, 0};
    if (from > 0) enter = std::max(enter, from / (from - to));
    if (to > 0) leave = std::min(leave, from / (from - to));
  }
  return {enter, leave};
}

/// A side that is not level, from its least to its greatest y.
struct Slant {
  Point low, high;
  [[nodiscard]] double at(double y) const {
    return low.x + (high.x - low.x) * std::clamp((y - low.y) / (high.y - low.y), 0.0, 1.0);
  }
};

/// On which side of the line from a to b the point lies, by the sign.
double side_of(const Point& a, const Point& b, const Point& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// The levels of the places where two sides cross.
std::set<double> crossings_of(const std::vector<Point>& ring) {
  std::set<double> levels;
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Point &a = ring[i], &b = ring[(i + 1) % n], &c = ring[j], &d = ring[(j + 1) % n];
      const double before = side_of(a, b, c), after = side_of(a, b, d);
      const bool is_crossed = before * after < 0 && side_of(c, d, a) * side_of(c, d, b) < 0;
      if (is_crossed) levels.insert(c.y + (d.y - c.y) * before / (before - after));
    }
  }
  return levels;
}

/// Not many more strips than this, nor sides that are compared each with each: of a tangle that would take
/// gigabytes nobody sees the inside.
constexpr std::size_t most_strips = 40'000, most_sides = 4'096;

/// The first, the last, and as many in between as come to `most` in all.
std::set<double> thinned_out(const std::set<double>& levels, std::size_t most) {
  const std::size_t step = levels.size() / most + 1;
  std::set<double> kept{*levels.rbegin()};
  std::size_t number = 0;
  for (const double level : levels)
    if (number++ % step == 0) kept.insert(level);
  return kept;
}

}  // namespace

std::vector<std::vector<Point>> clip_line(const std::vector<Point>& line, const PixelBox& box) {
  std::vector<std::vector<Point>> parts;
  bool is_open = false;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const auto [enter, leave] = inside(line[i], line[i + 1], sides_of(box));
    if (enter > leave) {
      is_open = false;
      continue;
    }
    if (!is_open || enter > 0) parts.push_back({into(mix(line[i], line[i + 1], enter), box)});
    parts.back().push_back(into(mix(line[i], line[i + 1], leave), box));
    is_open = leave == 1;
  }
  return parts;
}

/// I. E. Sutherland, G. W. Hodgman, "Reentrant Polygon Clipping", 1974.
std::vector<Point> clip_area(std::vector<Point> area, const PixelBox& box) {
  for (const HalfPlane& side : sides_of(box)) {
    std::vector<Point> kept;
    for (std::size_t i = 0; i < area.size(); ++i) {
      const Point& a = area[i];
      const Point& b = area[(i + 1) % area.size()];
      const double from = side.outside(a);
      const double to = side.outside(b);
      if (!std::isfinite(from - to)) return {};
      if (from <= 0) kept.push_back(a);
      if ((from < 0 && to > 0) || (from > 0 && to < 0)) kept.push_back(mix(a, b, from / (from - to)));
    }
    area = std::move(kept);
  }
  for (Point& p : area) p = into(p, box);
  return area;
}

std::vector<Strip> even_odd_strips(const std::vector<Point>& ring) {
  if (ring.size() > most_sides) return {};
  std::set<double> levels = crossings_of(ring);
  if (levels.empty()) return {};
  std::vector<Slant> sides;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    levels.insert(a.y);
    if (a.y != b.y) sides.push_back(a.y < b.y ? Slant{a, b} : Slant{b, a});
  }
  levels = thinned_out(levels, std::max<std::size_t>(16, most_strips / ring.size()));
  std::vector<Strip> strips;
  for (auto level = levels.begin(); std::next(level) != levels.end(); ++level) {
    const double low = *level, high = *std::next(level), middle = (low + high) / 2;
    std::vector<const Slant*> across;
    for (const Slant& side : sides)
      if (side.low.y <= middle && middle < side.high.y) across.push_back(&side);
    std::ranges::sort(across, [&](const Slant* a, const Slant* b) { return a->at(middle) < b->at(middle); });
    for (std::size_t i = 0; i + 1 < across.size(); i += 2) {
      const Slant &left = *across[i], &right = *across[i + 1];
      strips.push_back(
          {{{left.at(low), low}, {right.at(low), low}, {right.at(high), high}, {left.at(high), high}}});
    }
  }
  return strips;
}

}  // namespace rayproof::viz
