#include "viz/drawing/topics/ray_line.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "viz/trace/numbers.hpp"

namespace rayproof::viz {

void draw_ray_line(Picture& picture, const View& view, const RayLine& ray) {
  const Shadow left = view.centre.x - view.half_width();
  const Shadow right = view.centre.x + view.half_width();
  const Shadow from = ray.start ? std::clamp<Shadow>(*ray.start, left, right) : left;
  const Shadow to = ray.end ? std::clamp<Shadow>(*ray.end, left, right) : right;
  draw_curve(picture, view, {Role::muted, {}, 1.5, Pattern::dotted}, {{left, 0}, {right, 0}});
  draw_curve(picture, view, {Role::ray, {}, 2}, {{from, 0}, {to, 0}});
  if (to == right && from < right && view.shows({right - view.half_width() / 100, 0})) {
    const Point tip = view.to_pixels({right, 0});
    picture.elements.emplace_back(
        PixelLine{Role::ray, {{tip.x - 12, tip.y - 6}, {tip.x - 1, tip.y}, {tip.x - 12, tip.y + 6}}, 2});
  }
  if (ray.start) draw_mark(picture, view, Role::ray, MarkShape::dot, {*ray.start, 0});
  if (ray.end && view.shows({*ray.end, 0})) {
    const Point end = view.to_pixels({*ray.end, 0});
    picture.elements.emplace_back(PixelLine{Role::ray, {{end.x, end.y - 7}, {end.x, end.y + 7}}, 2});
  }
}

void draw_start_beyond(Picture& picture, const View& view, const RayLine& ray, const Shadow& distance) {
  if (!ray.start || view.shows({*ray.start, 0}) || !view.shows({view.centre.x, 0})) return;
  const PixelBox& frame = view.frame;
  const double y = view.to_pixels({view.centre.x, 0}).y;
  const bool is_left = *ray.start < view.centre.x;
  const double sign = is_left ? 1 : -1;
  const double x = (is_left ? frame.left : frame.right()) + 16 * sign;
  picture.elements.emplace_back(Mark{Role::ray, MarkShape::dot, {x, y}});
  for (const double shift : {20.0, 27.0}) {
    const double at = x + sign * shift;
    picture.elements.emplace_back(PixelLine{Role::text, {{at - 4, y + 9}, {at + 4, y - 9}}, 2});
  }
  picture.elements.emplace_back(Text{Role::text,
                                     {x, y - 18},
                                     fmt::format("start, {} off", rough(distance, 4)),
                                     is_left ? Anchor::start : Anchor::end,
                                     13,
                                     false,
                                     true});
}

}  // namespace rayproof::viz
