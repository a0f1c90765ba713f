#pragma once
/// \file
/// Where labels stand.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "viz/scene/shown_items.hpp"

namespace rayproof::viz {

[[nodiscard]] inline double shared_area(const PixelBox& a, const PixelBox& b) {
  const double x = std::min(a.right(), b.right()) - std::max(a.left, b.left);
  const double y = std::min(a.bottom(), b.bottom()) - std::max(a.top, b.top);
  return x > 0 && y > 0 ? x * y : 0;
}

[[nodiscard]] inline PixelBox box_around(const Point& middle, const std::string& label, double size) {
  const double width = text_width(label, size, true) + 4;
  const double height = size * 1.15;
  return {middle.x - width / 2, middle.y - height / 2, width, height};
}

class LabelPlaces {
 public:
  explicit LabelPlaces(const PixelBox& frame) : frame_(frame) {}

  /// What no label may cover: a text, a mark.
  void take(const PixelBox& box) { taken_.push_back(box); }
  void take(const Point& at, double radius) {
    taken_.push_back({at.x - radius, at.y - radius, 2 * radius, 2 * radius});
  }
  /// A line, which labels rather do not cover; `cost` for each place on it that one does.
  void avoid(const std::vector<Point>& line, double cost) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const double length = std::hypot(line[i + 1].x - line[i].x, line[i + 1].y - line[i].y);
      const int pieces = std::clamp(static_cast<int>(length / 5), 1, 400);
      for (int k = 0; k <= pieces; ++k) {
        const double part = static_cast<double>(k) / pieces;
        avoided_.push_back(
            {{line[i].x + part * (line[i + 1].x - line[i].x), line[i].y + part * (line[i + 1].y - line[i].y)},
             cost});
      }
    }
  }
  /// A place for a label beside one of the anchors, of which the first are the best; it is then taken. What
  /// `stands_there` stands at one where it covers nothing. Nothing where what it would cover costs more
  /// than `most`.
  [[nodiscard]] std::optional<Text> put(const std::string& label, const std::vector<Point>& anchors,
                                        double size, double most, bool stands_there) {
    const PixelBox own = box_around({0, 0}, label, size);
    PixelBox best{};
    double least = std::numeric_limits<double>::infinity(), covered = 0;
    const auto consider = [&](const Point& middle, double away, double rank) {
      const double far = std::max(0.0, away - 34);  // so far off it is read as another thing's name
      const double penalty = 1.5 * (away + far) + rank;
      const PixelBox box = box_around(middle, label, size);
      constexpr double half_line = 2, clear = 4;  // what has but one place stands there if it can
      const double cost = cost_of(box, away > 0 ? clear : half_line, least - penalty);
      if (penalty + cost >= least) return;
      least = penalty + cost;
      covered = cost + 3 * far;
      best = box;
    };
    for (std::size_t k = 0; stands_there && k < anchors.size(); ++k) {
      // A text too long for its place moves into the frame as far as it can.
      const double first = frame_.left + own.width / 2;
      const double last = std::max(first, frame_.right() - own.width / 2);
      consider({std::clamp(anchors[k].x, first, last), anchors[k].y}, 0, static_cast<double>(k) * 5);
    }
    for (std::size_t k = 0; k < anchors.size(); ++k) {
      for (const double away : {13.0, 22.0, 34.0, 48.0, 64.0}) {
        for (int i = 0; i < 16; ++i) {
          // Beginning above at the right, where a reader looks for it first.
          const double angle = std::numbers::pi * (0.25 + i / 8.0);
          consider({anchors[k].x + (away + own.width / 2) * std::cos(angle),
                    anchors[k].y - (away + own.height / 2) * std::sin(angle)},
                   away, i * 0.4 + static_cast<double>(k) * 5);
        }
      }
    }
    if (covered > most) return std::nullopt;
    return take(best, label, size);
  }

 private:
  [[nodiscard]] Text take(const PixelBox& box, const std::string& label, double size) {
    taken_.push_back(box);
    return {Role::text, {box.centre().x, box.bottom() - size * 0.27}, label, Anchor::middle, size, true,
            true};
  }
  /// What a label there costs, which keeps so far from lines; at least `most` where that is clear early.
  [[nodiscard]] double cost_of(const PixelBox& box, double distance, double most) const {
    const PixelBox wide{box.left - distance, box.top - distance, box.width + 2 * distance,
                        box.height + 2 * distance};
    double cost = 20 * (box.width * box.height - shared_area(box, frame_));  // outside of the frame
    for (const PixelBox& other : taken_) cost += 10 * shared_area(box, other);
    for (auto one = avoided_.begin(); one != avoided_.end() && cost < most; ++one)
      cost += wide.holds(one->at) ? one->cost : 0;
    return cost;
  }

  PixelBox frame_;
  std::vector<PixelBox> taken_{};
  struct Avoided {
    Point at;
    double cost;
  };
  std::vector<Avoided> avoided_{};
};

}  // namespace rayproof::viz
