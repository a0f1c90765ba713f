#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <utility>

#include "viz/flat/stage_picture.hpp"
#include "viz/picture/picture.hpp"
#include "viz/scene/items.hpp"
#include "viz/scene/shown_items.hpp"

namespace rayproof::viz {
namespace {

WorldLine rim_of(const StageItem& ellipsoid, const StageCamera& camera) {
  constexpr int sides = 96;
  WorldLine rim;
  for (int i = 0; i <= sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    rim.push_back(farthest_of(ellipsoid, std::cos(angle) * camera.right + std::sin(angle) * camera.up));
  }
  return rim;
}

struct Face {
  glm::dvec3 normal{0};  ///< outward, of unit length or 0
  bool is_front = false;
};

Face face_of(const WorldLine& ring, const glm::dvec3& middle, const glm::dvec3& toward) {
  Face face;
  for (std::size_t i = 0; i < ring.size(); ++i)
    face.normal += glm::cross(ring[i] - middle, ring[(i + 1) % ring.size()] - middle);
  const double size = glm::length(face.normal);
  if (size > 0) face.normal /= glm::dot(face.normal, ring.front() - middle) < 0 ? -size : size;
  face.is_front = glm::dot(face.normal, toward) > 0;
  return face;
}

SurfaceOutline solid_outline(const StageItem& solid, const StageCamera& camera) {
  constexpr double sharp = 0.866;  // faces more than 30° apart do not look like one round side
  glm::dvec3 middle(0);
  for (const glm::dvec3& p : solid.points) middle += p / static_cast<double>(solid.points.size());
  SurfaceOutline outline;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Face>> edges;
  for (const auto& corners : solid.faces) {
    WorldLine ring;
    for (const std::size_t i : corners) ring.push_back(solid.points[i]);
    const Face face = face_of(ring, middle, camera.toward);
    for (std::size_t i = 0; i < corners.size(); ++i)
      edges[std::minmax(corners[i], corners[(i + 1) % corners.size()])].push_back(face);
    if (face.is_front) outline.filled.push_back(std::move(ring));
  }
  for (const auto& [ends, faces] : edges) {
    const Face& one = faces.front();
    const Face& other = faces.back();
    const WorldLine line{solid.points[ends.first], solid.points[ends.second]};
    const bool is_sharp = glm::dot(one.normal, other.normal) < sharp;
    if (is_sharp || one.is_front != other.is_front)
      (one.is_front || other.is_front ? outline.seen : outline.hidden).push_back(line);
  }
  return outline;
}

double width_of(const StageItem& item, Emphasis emphasis) {
  if (item.role == Role::frame) return 1;
  if (emphasis == Emphasis::bright) return 2.8;
  if (emphasis == Emphasis::dimmed || item.pattern == Pattern::dashed) return 1.2;
  return item.role == Role::ray ? 2 : 1.8;
}

bool is_surface(const StageItem& item) {
  return item.form == Form::polygon || item.form == Form::solid || item.form == Form::ellipsoid;
}

class Painter {
 public:
  Painter(Picture& picture, const PixelBox& frame, const Stage& stage, const StageView& view)
      : picture_(picture), frame_(frame), camera_(stage.camera), view_(view) {}

  void fill(const ShownItem& shown) {
    if (shown.emphasis == Emphasis::dimmed || !is_surface(*shown.item)) return;
    Area area{shown.item->role};
    for (const WorldLine& ring : surface_outline(*shown.item, camera_).filled) {
      auto inside = clip_area(to_pixels(ring), frame_);
      if (!inside.empty()) area.rings.push_back(std::move(inside));
    }
    if (!area.rings.empty()) picture_.elements.emplace_back(std::move(area));
  }

  void stroke(const ShownItem& shown) {
    const StageItem& item = *shown.item;
    if (item.form == Form::point) return;
    PixelLine line{shown_role(shown), {}, width_of(item, shown.emphasis), item.pattern};
    if (is_surface(item)) {
      const SurfaceOutline outline = surface_outline(item, camera_);
      for (const WorldLine& seen : outline.seen) draw(line, to_pixels(seen));
      line.width = 1.2;
      line.pattern = Pattern::dashed;
      for (const WorldLine& hidden : outline.hidden) draw(line, to_pixels(hidden));
      return;
    }
    draw(line, to_pixels(item.points));
    if (item.form == Form::arrow) draw_head(item, line);
  }

  void mark(const ShownItem& shown) {
    const StageItem& item = *shown.item;
    if (item.form != Form::point || !has_mark(item.role)) return;
    const Point at = to_pixels(item.points.at(0));
    if (frame_.holds(at)) picture_.elements.emplace_back(Mark{shown_role(shown), mark_of(item.role), at});
  }

  [[nodiscard]] std::vector<Point> outline_of(const StageItem& item) const {
    return to_pixels(item.form == Form::ellipsoid ? surface_outline(item, camera_).seen.front()
                                                  : item.points);
  }

 private:
  [[nodiscard]] Point to_pixels(const glm::dvec3& p) const {
    const glm::dvec3 q = (p - view_.centre) * pixels_per_length(view_, frame_);
    const Point middle = frame_.centre();
    return {middle.x + glm::dot(q, camera_.right), middle.y - glm::dot(q, camera_.up)};
  }
  [[nodiscard]] std::vector<Point> to_pixels(const WorldLine& line) const {
    std::vector<Point> pixels;
    for (const glm::dvec3& p : line) pixels.push_back(to_pixels(p));
    return pixels;
  }

  void draw(PixelLine line, const std::vector<Point>& points) {
    for (auto& part : clip_line(points, frame_)) {
      line.points = std::move(part);
      picture_.elements.emplace_back(line);
    }
  }

  void draw_head(const StageItem& item, PixelLine line) {
    const Point from = to_pixels(item.points.at(0));
    const Point to = to_pixels(item.points.at(1));
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (!frame_.holds(to) || length < 2) return;
    const double size = std::min(11.0, length / 2);
    const Point along{(to.x - from.x) / length * size, (to.y - from.y) / length * size};
    const auto barb = [&](double side) {
      return Point{to.x - along.x - side * along.y * 0.5, to.y - along.y + side * along.x * 0.5};
    };
    line.pattern = Pattern::solid;
    draw(line, {barb(1), to, barb(-1)});
  }

  Picture& picture_;
  PixelBox frame_;
  const StageCamera& camera_;
  const StageView& view_;
};

}  // namespace

SurfaceOutline surface_outline(const StageItem& surface, const StageCamera& camera) {
  if (surface.form == Form::polygon) return {{surface.points}};
  if (surface.form == Form::solid) return solid_outline(surface, camera);
  const WorldLine rim = rim_of(surface, camera);
  return {{rim}, {rim}};
}

double pixels_per_length(const StageView& view, const PixelBox& frame) {
  constexpr double margin = 56;  // pixels, for marks and labels
  return std::min(frame.width / view_aspect - margin, frame.height - margin) / 2 / view.radius;
}

void draw_scene(Picture& picture, const PixelBox& frame, const Stage& stage, std::size_t step) {
  const std::vector<ShownItem> shown = shown_in(stage, step);
  Painter painter(picture, frame, stage, stage.steps[step].view);
  for (const ShownItem& one : shown) painter.fill(one);
  for (const ShownItem& one : shown) painter.stroke(one);
  for (const ShownItem& one : shown) painter.mark(one);
  draw_labels(picture, frame, shown, [&](const StageItem& item) { return painter.outline_of(item); });
}

Picture scene_picture(const Stage& stage, std::size_t step, double width, double height) {
  Picture picture{width, height, stage.steps[step].title, stage.steps[step].caption};
  draw_scene(picture, {0, 0, width, height}, stage, step);
  return picture;
}

}  // namespace rayproof::viz
