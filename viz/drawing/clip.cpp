#include "viz/drawing/clip.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace rayproof::viz {
namespace {

/// A side of a box as the half-plane nx·x + ny·y <= limit, in the numbers of a point type.
template <class P>
struct HalfPlane {
  using Number = decltype(P::x);
  int nx, ny;
  Number limit;
  [[nodiscard]] Number outside(const P& p) const { return nx * p.x + ny * p.y - limit; }
};

template <class P>
using HalfPlanes = std::array<HalfPlane<P>, 4>;

HalfPlanes<Point> sides_of(const PixelBox& box) {
  return {{{-1, 0, -box.left}, {1, 0, box.right()}, {0, -1, -box.top}, {0, 1, box.bottom()}}};
}

/// A few frames around the view's own: what a curve does farther out can't be seen.
HalfPlanes<WorldPoint> sides_around(const View& view) {
  const Shadow x = 4 * view.half_width();
  const Shadow y = 4 * view.half_height();
  const WorldPoint& c = view.centre;
  return {{{-1, 0, x - c.x}, {1, 0, x + c.x}, {0, -1, y - c.y}, {0, 1, y + c.y}}};
}

template <class P, class Number>
P mix(const P& a, const P& b, const Number& s) {
  return {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)};
}

/// The part [enter, leave] of the segment inside the sides (Liang and Barsky); empty where enter > leave.
template <class P>
std::array<decltype(P::x), 2> inside(const P& a, const P& b, const HalfPlanes<P>& sides) {
  using Number = decltype(P::x);
  Number enter = 0;
  Number leave = 1;
  for (const HalfPlane<P>& side : sides) {
    const Number from = side.outside(a);
    const Number to = side.outside(b);
    if (from > 0 && to > 0) return {1, 0};
    if (from > 0) enter = std::max<Number>(enter, from / (from - to));
    if (to > 0) leave = std::min<Number>(leave, from / (from - to));
  }
  return {enter, leave};
}

template <class P>
std::vector<std::vector<P>> line_inside(const std::vector<P>& line, const HalfPlanes<P>& sides) {
  std::vector<std::vector<P>> parts;
  bool is_open = false;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const auto [enter, leave] = inside(line[i], line[i + 1], sides);
    if (enter > leave) {
      is_open = false;
      continue;
    }
    if (!is_open || enter > 0) parts.push_back({mix(line[i], line[i + 1], enter)});
    parts.back().push_back(mix(line[i], line[i + 1], leave));
    is_open = leave == 1;
  }
  return parts;
}

template <class P>
std::vector<P> area_inside(std::vector<P> area, const HalfPlanes<P>& sides) {
  using Number = decltype(P::x);
  for (const HalfPlane<P>& side : sides) {
    std::vector<P> kept;
    for (std::size_t i = 0; i < area.size(); ++i) {
      const P& a = area[i];
      const P& b = area[(i + 1) % area.size()];
      const Number from = side.outside(a);
      const Number to = side.outside(b);
      if (from <= 0) kept.push_back(a);
      if ((from < 0 && to > 0) || (from > 0 && to < 0)) {
        kept.push_back(mix(a, b, Number(from / (from - to))));
      }
    }
    area = std::move(kept);
  }
  return area;
}

}  // namespace

std::vector<std::vector<Point>> clip_line(const std::vector<Point>& line, const PixelBox& box) {
  return line_inside(line, sides_of(box));
}

std::vector<Point> clip_area(std::vector<Point> area, const PixelBox& box) {
  return area_inside(std::move(area), sides_of(box));
}

std::vector<std::vector<WorldPoint>> clip_line_near(const std::vector<WorldPoint>& line, const View& view) {
  return line_inside(line, sides_around(view));
}

std::vector<WorldPoint> clip_area_near(std::vector<WorldPoint> area, const View& view) {
  return area_inside(std::move(area), sides_around(view));
}

}  // namespace rayproof::viz
