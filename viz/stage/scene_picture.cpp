#include <algorithm>
#include <cmath>

#include "viz/clip.hpp"
#include "viz/even_odd.hpp"
#include "viz/stage/label_places.hpp"
#include "viz/stage/projection.hpp"
#include "viz/stage/stage_picture.hpp"

namespace rayproof::viz {
namespace {

/// How an item is drawn: of the step itself, of a step before, or of the scene.
enum class Emphasis { scene, dimmed, bright };

double width_of(const StageItem& item, Emphasis emphasis) {
  if (emphasis == Emphasis::bright) return item.role == Role::frame ? 1 : 2.8;
  if (emphasis == Emphasis::dimmed) return 1.2;
  return item.role == Role::frame          ? 1
         : item.role == Role::ray          ? 2
         : item.pattern == Pattern::dashed ? 1.2
                                           : 1.8;
}

/// A text that stands at its point.
bool is_text(const StageItem& item) { return item.form == Form::point && item.role == Role::text; }

class Painter {
 public:
  Painter(Picture& picture, const ScreenProjection& projection)
      : picture_(picture), projection_(projection), places_(projection.frame) {}

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
      places_.avoid(part, emphasis == Emphasis::dimmed ? faint : plain);
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
    places_.take(at, mark_radius + 1);
  }

  void label(const StageItem& item, Emphasis emphasis) {
    if (item.label.empty()) return;
    const std::vector<Point> anchors = anchors_of(item);
    if (anchors.empty()) return;
    const bool is_bright = emphasis == Emphasis::bright;
    const double size = is_bright ? 16 : 13;
    auto text = is_text(item) ? places_.put_at(item.label, anchors[0], size)
                              : places_.put(item.label, anchors, size, is_bright);
    if (!text) return;
    text->role = role_of(item, emphasis);
    text->bold = is_bright;
    picture_.elements.emplace_back(*text);
  }

 private:
  static Role role_of(const StageItem& item, Emphasis emphasis) {
    return emphasis == Emphasis::dimmed ? Role::muted : item.role;
  }
  [[nodiscard]] bool shows(const Point& p) const {
    const PixelBox& f = projection_.frame;
    return p.x >= f.left && p.x <= f.right() && p.y >= f.top && p.y <= f.bottom();
  }

  [[nodiscard]] std::vector<Point> outline_of(const StageItem& item) const {
    if (item.form == Form::ellipsoid) return ellipsoid_outline(projection_, item.points);
    std::vector<Point> points = projection_.to_pixels(item.points);
    if (item.form != Form::hull) return points;
    points = hull_outline(points);
    if (!points.empty()) points.push_back(points.front());
    return points;
  }

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

  /// Where a label belongs, best first: the point, or places along what is seen of a line, from its middle.
  [[nodiscard]] std::vector<Point> anchors_of(const StageItem& item) const {
    const std::vector<Point> points = projection_.to_pixels(item.points);
    if (item.form == Form::point) return where_shown(points[0]);
    if (item.form == Form::polygon || item.form == Form::hull) {
      Point middle{};
      for (const Point& p : points) {
        middle.x += p.x / static_cast<double>(points.size());
        middle.y += p.y / static_cast<double>(points.size());
      }
      return where_shown(middle);
    }
    const auto parts = clip_line(points, projection_.frame);
    if (parts.empty()) return {};
    const std::vector<Point>& part = parts.back();
    if (item.role == Role::ray || part.size() > 2) return {part.back()};
    std::vector<Point> along;
    for (const double share : {0.5, 0.35, 0.65, 0.2, 0.8}) {
      along.push_back({part.front().x + share * (part.back().x - part.front().x),
                       part.front().y + share * (part.back().y - part.front().y)});
    }
    return along;
  }

  [[nodiscard]] std::vector<Point> where_shown(const Point& p) const {
    return shows(p) ? std::vector<Point>{p} : std::vector<Point>{};
  }

  /// What it costs a label to cover a place on a line.
  static constexpr double plain = 12;
  static constexpr double faint = 8;

  Picture& picture_;
  const ScreenProjection& projection_;
  LabelPlaces places_;
};

struct Shown {
  const StageItem* item;
  Emphasis emphasis;
};

/// In the order of painting: the scene, what was, what is new.
std::vector<Shown> shown_in(const Stage& stage, std::size_t step) {
  std::vector<Shown> shown;
  const bool is_apart = stage.steps[step].is_apart;
  if (!is_apart) {
    for (const StageItem& item : stage.scene) shown.push_back({&item, Emphasis::scene});
    std::size_t first = step;
    while (first > 0 && !stage.steps[first].begins_anew) --first;
    for (std::size_t before = first; before < step; ++before) {
      if (stage.steps[before].is_apart) continue;
      for (const StageItem& item : stage.steps[before].items) shown.push_back({&item, Emphasis::dimmed});
    }
  }
  for (const StageItem& item : stage.steps[step].items) shown.push_back({&item, Emphasis::bright});
  return shown;
}

}  // namespace

void draw_scene(Picture& picture, const PixelBox& frame, const Stage& stage, std::size_t step) {
  const ScreenProjection projection{stage.camera, stage.steps[step].view, frame};
  const std::vector<Shown> shown = shown_in(stage, step);
  Painter painter(picture, projection);
  for (const auto& [item, emphasis] : shown) painter.fill(*item, emphasis);
  for (const auto& [item, emphasis] : shown) painter.stroke(*item, emphasis);
  for (const auto& [item, emphasis] : shown) painter.mark(*item, emphasis);
  // What has but one place takes it first, then what is newest.
  for (const bool is_mere_text : {true, false}) {
    for (auto it = shown.rbegin(); it != shown.rend(); ++it) {
      if (is_text(*it->item) == is_mere_text) painter.label(*it->item, it->emphasis);
    }
  }
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
