#include <algorithm>
#include <cmath>

#include "viz/scene/label_places.hpp"
#include "viz/scene/space.hpp"

namespace rayproof::viz {
namespace {

/// A text that stands at its point.
bool is_text(const SpaceLabel& label) {
  return label.shown.item->form == Form::point && label.shown.item->role == Role::text;
}

class Labeller {
 public:
  Labeller(Picture& picture, const PixelBox& frame, const Projection& seen)
      : picture_(picture), frame_(frame), seen_(seen), places_(frame) {
    for (const Element& element : picture.elements)
      if (const auto* text = std::get_if<Text>(&element)) places_.take(box_of(*text));
  }

  /// No label may cover it.
  void keep_clear(const SpaceBody& body) {
    if (body.is_surface()) return;
    if (body.is_mark()) {
      for (const Point& at : in_frame(body.points)) places_.take(at, mark_radius + 1);
      return;
    }
    const auto avoid = [&](const glm::dvec3& from, const glm::dvec3& to) {
      const auto start = seen_(from), end = seen_(to);
      if (start && end) places_.avoid(*start, *end, body.shown.emphasis == Emphasis::dimmed ? faint : plain);
    };
    for (const SpacePoints& piece : body.pieces)
      for (std::size_t i = 0; i + 1 < piece.size(); ++i) avoid(piece[i], piece[i + 1]);
    if (body.head) avoid(body.head->base, body.head->tip);
  }

  void write(const SpaceLabel& label) {
    const std::string& words = label.shown.item->label;
    const std::vector<Point> anchors = anchors_of(label);
    if (anchors.empty() || is_written(words, anchors[0])) return;
    const bool is_bright = label.shown.emphasis == Emphasis::bright;
    const double size = is_bright ? 16 : 14.4;  // 24 pixels of a slide: large letters
    auto text = is_text(label) ? places_.put_at(words, anchors[0], size)
                               : places_.put(words, anchors, size, is_bright);
    if (!text) return;
    text->role = label_role(label.shown);
    text->bold = is_bright;
    picture_.elements.emplace_back(*text);
    written_.emplace_back(words, anchors[0]);
  }

 private:
  /// Whether the same stands there already, of a newer step.
  [[nodiscard]] bool is_written(const std::string& label, const Point& at) const {
    return std::any_of(written_.begin(), written_.end(), [&](const auto& one) {
      return one.first == label && std::hypot(one.second.x - at.x, one.second.y - at.y) < 2 * mark_radius;
    });
  }

  [[nodiscard]] std::vector<Point> in_frame(const SpacePoints& points) const {
    std::vector<Point> found;
    for (const glm::dvec3& p : points) {
      const auto at = seen_(p);
      if (at && frame_.holds(*at)) found.push_back(*at);
    }
    return found;
  }

  /// Where a label belongs, best first: the point, or places along what is seen of a line, from its middle.
  [[nodiscard]] std::vector<Point> anchors_of(const SpaceLabel& label) const {
    if (label.points.size() == 1) return in_frame(label.points);
    constexpr int pieces = 128;
    SpacePoints line;
    for (int i = 0; i <= pieces; ++i)
      line.push_back(label.points[0] + static_cast<double>(i) / pieces * (label.points[1] - label.points[0]));
    const std::vector<Point> along = in_frame(line);
    if (along.empty()) return {};
    if (label.is_at_end) return {along.back()};
    std::vector<Point> anchors;
    for (const double share : {0.5, 0.35, 0.65, 0.2, 0.8})
      anchors.push_back(along[static_cast<std::size_t>(share * static_cast<double>(along.size() - 1))]);
    return anchors;
  }

  /// What it costs a label to cover a place on a line.
  static constexpr double plain = 20;
  static constexpr double faint = 12;

  Picture& picture_;
  PixelBox frame_;
  const Projection& seen_;
  LabelPlaces places_;
  std::vector<std::pair<std::string, Point>> written_{};
};

}  // namespace

void draw_labels(Picture& picture, const PixelBox& frame, const Space& space, const Projection& seen) {
  Labeller labeller(picture, frame, seen);
  for (const SpaceBody& body : space.bodies) labeller.keep_clear(body);
  // What has but one place takes it first, then what is newest.
  for (const bool is_mere_text : {true, false})
    for (const SpaceLabel& label : space.labels)
      if (is_text(label) == is_mere_text) labeller.write(label);
}

}  // namespace rayproof::viz
