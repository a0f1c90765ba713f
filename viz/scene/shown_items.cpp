#include "viz/scene/shown_items.hpp"

#include <algorithm>
#include <cmath>

#include "viz/picture/clip.hpp"
#include "viz/scene/label_places.hpp"

namespace rayproof::viz {
namespace {

/// A text that stands at its point.
bool is_text(const StageItem& item) { return item.form == Form::point && item.role == Role::text; }

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
    if (item.form == Form::polygon || item.form == Form::solid) return;
    const std::vector<Point> points = outline_(item);
    if (item.form == Form::point) {
      if (has_mark(item.role) && !points.empty() && frame_.holds(points[0]))
        places_.take(points[0], mark_radius + 6);
      return;
    }
    for (const auto& part : clip_line(points, frame_))
      places_.avoid(part, shown.emphasis == Emphasis::dimmed ? faint : plain);
  }

  void label(const ShownItem& shown) {
    const StageItem& item = *shown.item;
    if (item.label.empty()) return;
    const std::vector<Point> anchors = anchors_of(item);
    if (anchors.empty() || is_written(item.label, anchors[0])) return;
    const bool is_bright = shown.emphasis == Emphasis::bright;
    const double size = is_bright ? 16 : 14.4;  // 24 pixels of a slide: large letters
    auto text = is_text(item) ? places_.put_at(item.label, anchors[0], size)
                              : places_.put(item.label, anchors, size, is_bright);
    if (!text) return;
    text->role = label_role(shown);
    text->bold = is_bright;
    picture_.elements.emplace_back(*text);
    written_.emplace_back(item.label, anchors[0]);
  }

 private:
  /// Whether the same stands there already, of a newer step.
  [[nodiscard]] bool is_written(const std::string& label, const Point& at) const {
    return std::any_of(written_.begin(), written_.end(), [&](const auto& one) {
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
      return where_shown(middle);
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
  static constexpr double plain = 12;
  static constexpr double faint = 8;

  Picture& picture_;
  PixelBox frame_;
  const Outline& outline_;
  LabelPlaces places_;
  std::vector<std::pair<std::string, Point>> written_{};
};

}  // namespace

std::vector<ShownItem> shown_in(const Stage& stage, std::size_t step) {
  std::vector<ShownItem> shown;
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

void draw_labels(Picture& picture, const PixelBox& frame, const std::vector<ShownItem>& shown,
                 const Outline& outline, const std::optional<PixelBox>& taken) {
  Labeller labeller(picture, frame, outline);
  if (taken) labeller.keep_clear(*taken);
  for (const ShownItem& one : shown) labeller.keep_clear(one);
  // What has but one place takes it first, then what is newest.
  for (const bool is_mere_text : {true, false}) {
    for (auto it = shown.rbegin(); it != shown.rend(); ++it) {
      if (is_text(*it->item) == is_mere_text) labeller.label(*it);
    }
  }
}

}  // namespace rayproof::viz
