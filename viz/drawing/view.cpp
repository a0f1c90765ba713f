#include "viz/drawing/view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "viz/drawing/clip.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

/// Beyond this many pixels from the frame only directions matter; keeps doubles and file sizes sane.
constexpr double far_away = 1e6;

std::vector<Point> all_to_pixels(const View& view, const std::vector<WorldPoint>& points) {
  std::vector<Point> pixels;
  pixels.reserve(points.size());
  for (const WorldPoint& p : points) pixels.push_back(view.to_pixels(p));
  return pixels;
}

/// The largest 1, 2 or 5 times a power of ten that is at most `most`.
double round_length(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  for (const double step : {5.0, 2.0}) {
    if (step * power <= most) return step * power;
  }
  return power;
}

}  // namespace

Point View::to_pixels(const WorldPoint& p) const {
  Shadow x = (p.x - centre.x) * scale_x;
  Shadow y = (centre.y - p.y) * scale_y;
  const Shadow size = std::max<Shadow>(abs(x), abs(y));
  if (size > far_away) {
    x *= far_away / size;
    y *= far_away / size;
  }
  const Point middle = frame.centre();
  return {middle.x + static_cast<double>(x), middle.y + static_cast<double>(y)};
}

bool View::shows(const WorldPoint& p) const {
  const Point at = to_pixels(p);
  return at.x >= frame.left && at.x <= frame.right() && at.y >= frame.top && at.y <= frame.bottom();
}

View View::around(const PixelBox& frame, const WorldPoint& centre, const Shadow& half_width,
                  const Shadow& half_height) {
  const Shadow scale = std::min<Shadow>(frame.width / 2 / half_width, frame.height / 2 / half_height);
  return {frame, centre, scale, scale};
}

void draw_curve(Picture& picture, const View& view, PixelLine line, const std::vector<WorldPoint>& points) {
  for (const auto& near_part : clip_line_near(points, view)) {
    for (auto& part : clip_line(all_to_pixels(view, near_part), view.frame)) {
      line.points = std::move(part);
      picture.elements.emplace_back(line);
    }
  }
}

void draw_area(Picture& picture, const View& view, Role role, const std::vector<WorldPoint>& points) {
  auto inside = clip_area(all_to_pixels(view, clip_area_near(points, view)), view.frame);
  if (!inside.empty()) picture.elements.emplace_back(Area{role, std::move(inside)});
}

void draw_mark(Picture& picture, const View& view, Role role, MarkShape shape, const WorldPoint& at) {
  if (view.shows(at)) picture.elements.emplace_back(Mark{role, shape, view.to_pixels(at)});
}

void draw_frame(Picture& picture, const PixelBox& b, const std::string& caption) {
  picture.elements.emplace_back(PixelLine{
      Role::frame,
      {{b.left, b.top}, {b.right(), b.top}, {b.right(), b.bottom()}, {b.left, b.bottom()}, {b.left, b.top}},
      1});
  picture.elements.emplace_back(Text{Role::muted, {b.left, b.top - 8}, caption, Anchor::start, 13});
}

void draw_scale_bars(Picture& picture, const View& view) {
  const PixelBox& b = view.frame;
  const auto unit = static_cast<double>(view.scale_x);
  if (!std::isnormal(unit) || !std::isnormal(90 / unit)) return;
  const double length = round_length(90 / unit);
  const double y = b.bottom() - 14;
  const double x = b.left + 14;
  const double end = x + length * unit;
  picture.elements.emplace_back(
      PixelLine{Role::muted, {{x, y - 4}, {x, y + 4}, {x, y}, {end, y}, {end, y - 4}, {end, y + 4}}});
  picture.elements.emplace_back(
      Text{Role::muted, {end + 6, y + 4}, rough(length), Anchor::start, 12, false, true});
  if (view.scale_x == view.scale_y) return;
  const auto unit_y = static_cast<double>(view.scale_y);
  if (!std::isnormal(unit_y) || !std::isnormal(60 / unit_y)) return;
  const double height = round_length(60 / unit_y);
  const double right = b.right() - 14;
  const double top = y - height * unit_y;
  picture.elements.emplace_back(PixelLine{
      Role::muted,
      {{right - 4, y}, {right + 4, y}, {right, y}, {right, top}, {right - 4, top}, {right + 4, top}}});
  picture.elements.emplace_back(
      Text{Role::muted, {right - 8, (y + top) / 2 + 4}, rough(height), Anchor::end, 12, false, true});
}

/// By the tangent of half the angle from the point F nearest the middle of the view, which is exact without
/// sines: F + r·2w/(1 + w²) along the tangent and r·2w²/(1 + w²) inward.
std::vector<WorldPoint> circle_outline(const View& view, const WorldPoint& centre, const Shadow& radius) {
  WorldPoint out{view.centre.x - centre.x, view.centre.y - centre.y};
  const Shadow length = sqrt(out.x * out.x + out.y * out.y);
  out = length > radius * Shadow(0x1p-20) ? WorldPoint{out.x / length, out.y / length} : WorldPoint{0, 1};
  const Shadow reach = std::max<Shadow>(view.half_width(), view.half_height()) * 3;
  std::vector<Shadow> half_tangents;
  if (reach >= radius) {
    for (int i = 0; i < 180; ++i) half_tangents.emplace_back(std::tan(std::numbers::pi * (i + 0.5) / 360));
  } else {
    for (int i = 0; i < 240; ++i) half_tangents.push_back(reach / radius * std::pow((i + 0.5) / 240, 2));
    while (half_tangents.back() < 100) half_tangents.push_back(half_tangents.back() * 2);
  }
  std::vector<WorldPoint> outline;
  const auto add = [&](const Shadow& w) {
    const Shadow along = 2 * w / (1 + w * w) * radius;
    const Shadow outward = radius - along * w;
    outline.push_back(
        {centre.x + outward * out.x - along * out.y, centre.y + outward * out.y + along * out.x});
  };
  for (auto w = half_tangents.rbegin(); w != half_tangents.rend(); ++w) add(-*w);
  for (const Shadow& w : half_tangents) add(w);
  outline.push_back(outline.front());
  return outline;
}

}  // namespace rayproof::viz
