#include "viz/scene/shown_items.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "viz/picture/picture.hpp"
#include "viz/scene/label_places.hpp"

namespace rayproof::viz {
namespace {

/// A text that names its point's surroundings and stands there.
bool is_text(const StageItem& item) { return item.form == Form::point && item.role == Role::text; }

/// What has but one place; of an earlier step it is left out where that is taken.
bool stands_first(const ShownItem& shown) {
  return is_text(*shown.item) && shown.emphasis != Emphasis::dimmed;
}

class Labeller {
 public:
  Labeller(Picture& picture, const PixelBox& frame, const Outline& outline)
      : picture_(picture), frame_(frame), outline_(outline), places_(frame) {
    for (const Element& element : picture.elements)
      if (const auto* text = std::get_if<Text>(&element)) places_.take(box_of(*text));
  }

  /// No label may cover it.
  void keep_clear(const PixelBox& box) { places_.take(box); }
  void keep_clear(const ShownItem& shown) {
    const StageItem& item = *shown.item;
    const bool is_frame = item.role == Role::frame;
    const double cost = is_frame && shown.emphasis == Emphasis::scene    ? hair
                        : is_frame || shown.emphasis == Emphasis::dimmed ? faint
                                                                         : plain;
    if (item.form == Form::solid) {
      // The edges of round sides are not drawn.
      for (const auto& corners : item.faces) {
        if (item.faces.size() <= 12) avoid(ring_of(item, corners), cost);
      }
      return;
    }
    std::vector<Point> points = outline_(item);
    if (points.empty() || item.is_open) return;
    if (item.form == Form::point || item.form == Form::arrow) {
      const bool is_seen = item.form == Form::arrow || has_mark(item.role);
      if (is_seen && frame_.holds(points.back()))
        places_.take(points.back(), item.form == Form::arrow ? head_radius : mark_radius + 6);
      if (item.form == Form::arrow) keep_head_clear(points.front(), points.back());
    }
    if (item.form == Form::polygon) points.push_back(points.front());
    avoid(points, cost);
  }

  void label(const ShownItem& shown) {
    const StageItem& item = *shown.item;
    const std::string label = typeset(item.label);
    if (label.empty()) return;
    const std::vector<Point> anchors = anchors_of(item);
    if (anchors.empty() || is_written(label, anchors[0])) return;
    const bool is_bright = shown.emphasis == Emphasis::bright;
    const double size = is_bright ? 16 : 14.4;  // 24 pixels of a slide: large letters
    const double most = is_bright || stands_first(shown)     ? must
                        : shown.emphasis == Emphasis::dimmed ? few
                                                             : several;
    auto text = places_.put(label, anchors, size, most, is_text(item) || item.form == Form::polygon);
    if (!text) return;
    text->role = label_role(shown);
    text->bold = is_bright;
    picture_.elements.emplace_back(*text);
    written_.emplace_back(label, anchors[0]);
  }

 private:
  void avoid(const std::vector<Point>& line, double cost) {
    for (const auto& part : clip_line(line, frame_)) places_.avoid(part, cost);
  }

  /// Where an arrow's head begins, it is as wide as long.
  void keep_head_clear(const Point& from, const Point& tip) {
    const double length = std::hypot(tip.x - from.x, tip.y - from.y);
    if (!(length > 4 * head_radius)) return;
    const double back = 1.6 * head_radius / length;
    const Point base{tip.x + back * (from.x - tip.x), tip.y + back * (from.y - tip.y)};
    if (frame_.holds(base)) places_.take(base, head_radius);
  }

  [[nodiscard]] std::vector<Point> ring_of(const StageItem& solid,
                                           const std::vector<std::size_t>& corners) const {
    StageItem face{solid.role, Form::polyline};
    for (const std::size_t corner : corners) face.points.push_back(solid.points[corner]);
    face.points.push_back(face.points.front());
    return outline_(face);
  }

  /// Whether the same stands there already, of a newer step.
  [[nodiscard]] bool is_written(const std::string& label, const Point& at) const {
    return std::ranges::any_of(written_, [&](const auto& one) {
      return one.first == label && std::hypot(one.second.x - at.x, one.second.y - at.y) < 2 * mark_radius;
    });
  }

  /// Where a label belongs, best first: the point, or places along what is seen of a line, from its middle.
  [[nodiscard]] std::vector<Point> anchors_of(const StageItem& item) const {
    const std::vector<Point> points = outline_(item);
    if (points.empty()) return {};
    if (item.form == Form::point) return where_shown(points[0]);
    if (item.form == Form::polygon || item.form == Form::solid) {
      Point middle{};
      for (const Point& p : points) {
        middle.x += p.x / static_cast<double>(points.size());
        middle.y += p.y / static_cast<double>(points.size());
      }
      std::vector<Point> anchors = where_shown(middle);
      // From a polygon's middle toward those of its sides, and there, for what its inside has no room for.
      for (const double part : {1.0 / 3, 1.0}) {
        for (std::size_t i = 0; item.form == Form::polygon && !item.is_open && i < points.size(); ++i) {
          const Point &p = points[i], &q = points[(i + 1) % points.size()];
          const Point side{(p.x + q.x) / 2, (p.y + q.y) / 2};
          for (const Point& at :
               where_shown({middle.x + part * (side.x - middle.x), middle.y + part * (side.y - middle.y)}))
            anchors.push_back(at);
        }
      }
      return anchors;
    }
    const auto parts = clip_line(points, frame_);
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
    return frame_.holds(p) ? std::vector<Point>{p} : std::vector<Point>{};
  }

  /// What it costs a label to cover a place on a line.
  static constexpr double plain = 12, faint = 8, hair = 3;
  /// What a label may cost: of an earlier step it is rather left out than to cover a line.
  static constexpr double few = 4 * faint, several = 12 * plain,
                          must = std::numeric_limits<double>::infinity();
  static constexpr double head_radius = 9;  ///< of an arrow's head

  Picture& picture_;
  PixelBox frame_;
  const Outline& outline_;
  LabelPlaces places_;
  std::vector<std::pair<std::string, Point>> written_{};
};

}  // namespace

/// Whether the step has a point that stands for this one, of an earlier step.
static bool is_replaced(const StageItem& item, const StageStep& step) {
  return std::ranges::any_of(step.items, [&](const StageItem& other) {
    return other.stands_for_earlier && other.role == item.role && other.points == item.points;
  });
}

std::vector<ShownItem> shown_in(const Stage& stage, std::size_t step) {
  std::vector<ShownItem> shown;
  const bool is_apart = stage.steps[step].is_apart;
  if (!is_apart) {
    for (const StageItem& item : stage.scene) shown.push_back({&item, Emphasis::scene});
    std::size_t first = step;
    while (first > 0 && !stage.steps[first].begins_anew) --first;
    for (std::size_t before = first; before < step; ++before) {
      if (stage.steps[before].is_apart) continue;
      for (const StageItem& item : stage.steps[before].items)
        if (!is_replaced(item, stage.steps[step])) shown.push_back({&item, Emphasis::dimmed});
    }
  }
  for (const StageItem& item : stage.steps[step].items) shown.push_back({&item, Emphasis::bright});
  return shown;
}

void draw_labels(Picture& picture, const PixelBox& frame, const std::vector<ShownItem>& shown,
                 const Outline& outline, const std::optional<PixelBox>& taken) {
  Labeller labeller(picture, frame, outline);
  if (taken) labeller.keep_clear(*taken);
  for (const ShownItem& one : shown) labeller.keep_clear(one);
  // What has but one place takes it first, then what is newest.
  for (const bool is_first : {true, false}) {
    for (auto it = shown.rbegin(); it != shown.rend(); ++it) {
      if (stands_first(*it) == is_first) labeller.label(*it);
    }
  }
}

}  // namespace rayproof::viz
