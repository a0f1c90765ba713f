#include <algorithm>
#include <cmath>

#include "viz/drawing/clip.hpp"
#include "viz/drawing/even_odd.hpp"
#include "viz/flat/projection.hpp"
#include "viz/flat/stage_picture.hpp"
#include "viz/scene/shown_items.hpp"

namespace rayproof::viz {
namespace {

double width_of(const StageItem& item, Emphasis emphasis) {
  if (emphasis == Emphasis::bright) return item.role == Role::frame ? 1 : 2.8;
  if (emphasis == Emphasis::dimmed) return 1.2;
  return item.role == Role::frame          ? 1
         : item.role == Role::ray          ? 2
         : item.pattern == Pattern::dashed ? 1.2
                                           : 1.8;
}

class Painter {
 public:
  Painter(Picture& picture, const ScreenProjection& projection)
      : picture_(picture), projection_(projection) {}

  void fill(const StageItem& item, Emphasis emphasis) {
    if (emphasis == Emphasis::dimmed) return;
    if (item.form == Form::polygon) return fill_polygon(item);
    if (item.form != Form::hull && item.form != Form::ellipsoid) return;
    const auto inside = clip_area(outline_of(item), projection_.frame);
    if (!inside.empty()) picture_.elements.emplace_back(Area{item.role, inside});
  }

  void stroke(const StageItem& item, Emphasis emphasis) {
    if (item.form == Form::point || item.form == Form::polygon) return;
    PixelLine line{role_of(item, emphasis), {}, width_of(item, emphasis), item.pattern};
    for (auto& part : clip_line(outline_of(item), projection_.frame)) {
      line.points = std::move(part);
      picture_.elements.emplace_back(line);
    }
    if (item.form == Form::arrow) draw_head(item, line);
  }

  void mark(const StageItem& item, Emphasis emphasis) {
    if (item.form != Form::point || !has_mark(item.role)) return;
    const Point at = projection_.to_pixels(item.points.at(0));
    if (!shows(at)) return;
    picture_.elements.emplace_back(Mark{role_of(item, emphasis), mark_of(item.role), at});
  }

  /// As it is seen, in pixels.
  [[nodiscard]] std::vector<Point> outline_of(const StageItem& item) const {
    if (item.form == Form::ellipsoid) return ellipsoid_outline(projection_, item.points);
    std::vector<Point> points = projection_.to_pixels(item.points);
    if (item.form != Form::hull) return points;
    points = hull_outline(points);
    if (!points.empty()) points.push_back(points.front());
    return points;
  }

 private:
  static Role role_of(const StageItem& item, Emphasis emphasis) {
    return emphasis == Emphasis::dimmed ? Role::muted : item.role;
  }
  [[nodiscard]] bool shows(const Point& p) const { return projection_.frame.holds(p); }

  void fill_polygon(const StageItem& item) {
    // In pixels already: a view that changes nothing but the direction of y.
    const View pixels{projection_.frame, {projection_.frame.centre().x, -projection_.frame.centre().y}, 1, 1};
    std::vector<WorldPoint> ring;
    for (const Point& p : projection_.to_pixels(item.points)) ring.push_back({p.x, -p.y});
    draw_even_odd(picture_, pixels, item.role, ring);
  }

  void draw_head(const StageItem& item, PixelLine line) {
    const Point from = projection_.to_pixels(item.points.at(0));
    const Point to = projection_.to_pixels(item.points.at(1));
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (!shows(to) || length < 2) return;
    const double size = std::min(11.0, length / 2);
    const Point along{(to.x - from.x) / length * size, (to.y - from.y) / length * size};
    const auto barb = [&](double side) {
      return Point{to.x - along.x - side * along.y * 0.5, to.y - along.y + side * along.x * 0.5};
    };
    line.pattern = Pattern::solid;
    line.points = {barb(1), to, barb(-1)};
    picture_.elements.emplace_back(line);
  }

  Picture& picture_;
  const ScreenProjection& projection_;
};

}  // namespace

void draw_scene(Picture& picture, const PixelBox& frame, const Stage& stage, std::size_t step) {
  const ScreenProjection projection{stage.camera, stage.steps[step].view, frame};
  const std::vector<ShownItem> shown = shown_in(stage, step);
  Painter painter(picture, projection);
  for (const auto& [item, emphasis] : shown) painter.fill(*item, emphasis);
  for (const auto& [item, emphasis] : shown) painter.stroke(*item, emphasis);
  for (const auto& [item, emphasis] : shown) painter.mark(*item, emphasis);
  draw_labels(picture, frame, shown, [&](const StageItem& item) { return painter.outline_of(item); });
}

Picture scene_picture(const Stage& stage, std::size_t step, double width, double height) {
  Picture picture;
  picture.width = width;
  picture.height = height;
  picture.title = stage.steps[step].title;
  picture.description = stage.steps[step].caption;
  draw_scene(picture, {0, 0, width, height}, stage, step);
  return picture;
}

}  // namespace rayproof::viz
