#include "viz/drawing/topics/fit.hpp"

#include <algorithm>

namespace rayproof::viz {
namespace {

/// A figure smaller than this, in pixels, is too small to see.
constexpr double least_shown = 40;

View around(const PixelBox& frame, const Extent& e) {
  const Shadow unit = e.half_size();
  return View::around(frame, {(e.left + e.right) / 2, (e.bottom + e.top) / 2},
                      (e.right - e.left) * Shadow(0.56) + unit * Shadow(0.1),
                      (e.top - e.bottom) * Shadow(0.62) + unit * Shadow(0.04));
}

}  // namespace

Extent Extent::of(const std::vector<WorldPoint>& points) {
  Extent extent{points.front().x, points.front().x, points.front().y, points.front().y};
  for (const WorldPoint& p : points) extent.include(p);
  return extent;
}

Shadow Extent::half_size() const { return std::max<Shadow>(right - left, top - bottom) / 2; }

void Extent::include(const WorldPoint& p) {
  left = std::min<Shadow>(left, p.x);
  right = std::max<Shadow>(right, p.x);
  bottom = std::min<Shadow>(bottom, p.y);
  top = std::max<Shadow>(top, p.y);
}

Fitted fit(const PixelBox& frame, const Extent& figure, const RayLine& ray,
           const std::vector<NamedMark>& hits) {
  const Shadow middle = (figure.left + figure.right) / 2;
  Extent shown = figure;
  Shadow size = figure.half_size() * 2;
  const auto is_speck = [&](const Extent& e) {
    return size > 0 && size * around(frame, e).scale_x < least_shown;
  };
  Extent with_line = figure;
  with_line.include({std::clamp<Shadow>(0, figure.left, figure.right), 0});
  if (is_speck(with_line)) return {around(frame, figure), false, true};
  shown = with_line;
  const Shadow reach = 4 * shown.half_size();
  for (const NamedMark& hit : hits) {
    if (abs(hit.at.x - middle) <= reach) shown.include(hit.at);
  }
  Fitted fitted;
  Extent with_start = shown;
  if (ray.start) with_start.include({*ray.start, 0});
  fitted.leaves_start_out = is_speck(with_start);
  if (!fitted.leaves_start_out) shown = with_start;
  if (shown.half_size() == 0) {  // a point, and the ray's start in it
    shown.include({shown.left - 1, shown.bottom - 1});
    shown.include({shown.right + 1, shown.top + 1});
  }
  fitted.view = around(frame, shown);
  return fitted;
}

}  // namespace rayproof::viz
