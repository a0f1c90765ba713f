#include <algorithm>
#include <glm/geometric.hpp>

#include "viz/flat/outline.hpp"
#include "viz/flat/stage_picture.hpp"
#include "viz/scene/space.hpp"

namespace rayproof::viz {
namespace {

double width_of(const ShownItem& shown) {
  const StageItem& item = *shown.item;
  if (item.role == Role::frame) return 1;
  if (shown.emphasis == Emphasis::bright) return 2.8;
  if (shown.emphasis == Emphasis::dimmed || item.pattern == Pattern::dashed) return 1.2;
  return item.role == Role::ray ? 2 : 1.8;
}

/// Paints what is built of a step straight on, as the stage's own camera sees it.
class Painter {
 public:
  Painter(Picture& picture, const PixelBox& frame, const StageCamera& camera, const StageView& view)
      : picture_(picture),
        middle_(frame.centre()),
        camera_(camera),
        scale_(view.radius * pixels_per_length(view, frame)) {}

  [[nodiscard]] Point to_pixels(const glm::dvec3& p) const {
    return {middle_.x + scale_ * glm::dot(p, camera_.right), middle_.y - scale_ * glm::dot(p, camera_.up)};
  }

  void fill(const SpaceBody& body) {
    if (!body.is_surface() || body.shown.emphasis == Emphasis::dimmed) return;
    Area area{body.shown.item->role};
    for (const WorldLine& ring : outline_of(body).filled) area.rings.push_back(to_pixels(ring));
    picture_.elements.emplace_back(std::move(area));
  }

  void stroke(const SpaceBody& body) {
    if (body.is_mark()) return;
    PixelLine line{shown_role(body.shown), {}, width_of(body.shown), body.shown.item->pattern};
    if (!body.is_surface()) {
      SpacePoints all;  // the dashes lie along the line
      for (const SpacePoints& piece : body.pieces) all.insert(all.end(), piece.begin(), piece.end());
      if (body.head) all.push_back(body.head->tip);
      draw(line, all);
      if (body.head) draw_head(*body.head, line);
      return;
    }
    const SurfaceOutline outline = outline_of(body);
    for (const WorldLine& seen : outline.seen) draw(line, seen);
    line.width = 1.2;
    line.pattern = Pattern::dashed;
    for (const WorldLine& hidden : outline.hidden) draw(line, hidden);
  }

  void mark(const SpaceBody& body) {
    if (body.is_mark())
      picture_.elements.emplace_back(
          Mark{shown_role(body.shown), mark_of(body.shown.item->role), to_pixels(body.points[0])});
  }

 private:
  [[nodiscard]] SurfaceOutline outline_of(const SpaceBody& body) const {
    StageItem placed = *body.shown.item;
    placed.points = body.points;
    return surface_outline(placed, camera_);
  }
  [[nodiscard]] std::vector<Point> to_pixels(const WorldLine& line) const {
    std::vector<Point> pixels;
    for (const glm::dvec3& p : line) pixels.push_back(to_pixels(p));
    return pixels;
  }
  void draw(PixelLine line, const SpacePoints& points) {
    line.points = to_pixels(points);
    picture_.elements.emplace_back(std::move(line));
  }
  void draw_head(const ArrowHead& head, PixelLine line) {
    const glm::dvec3 along = 0.8 * (head.tip - head.base);
    const glm::dvec3 aside = 0.5 * glm::cross(camera_.toward, along);
    line.pattern = Pattern::solid;
    draw(line, {head.tip - along + aside, head.tip, head.tip - along - aside});
  }

  Picture& picture_;
  Point middle_;
  const StageCamera& camera_;
  double scale_;
};

}  // namespace

double pixels_per_length(const StageView& view, const PixelBox& frame) {
  constexpr double margin = 56;  // pixels, for marks and labels
  return std::min(frame.width / view_aspect - margin, frame.height - margin) / 2 / view.radius;
}

void draw_scene(Picture& picture, const PixelBox& frame, const Stage& stage, std::size_t step) {
  const Space space = space_of(stage, step);
  Painter painter(picture, frame, stage.camera, space.view);
  picture.elements.emplace_back(Window{frame, true});
  for (const SpaceBody& body : space.bodies) painter.fill(body);
  for (const SpaceBody& body : space.bodies) painter.stroke(body);
  for (const SpaceBody& body : space.bodies) painter.mark(body);
  picture.elements.emplace_back(Window{frame, false});
  draw_labels(picture, frame, space, [&](const glm::dvec3& p) { return painter.to_pixels(p); });
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
