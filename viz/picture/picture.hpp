#pragma once
/// \file
/// A picture as data: lines, areas, marks and text in pixels. SVG is a sink of it, and VTK of what stands
/// over a scene: text, marks and solid lines.

#include <string>
#include <variant>
#include <vector>

namespace rayproof::viz {

/// What an element stands for. The sinks give each role one colour, in a light and a dark scheme
/// (palette.hpp); no meaning rests on colour alone: marks and line patterns differ too.
enum class Role { background, frame, text, muted, surface, ray, exact, claimed, nearest, normal, edge };
inline constexpr int role_count = 11;

/// In pixels from the top left corner, y down.
struct Point {
  double x = 0;
  double y = 0;
};
struct PixelBox {
  double left = 0;
  double top = 0;
  double width = 0;
  double height = 0;
  [[nodiscard]] double right() const { return left + width; }
  [[nodiscard]] double bottom() const { return top + height; }
  [[nodiscard]] Point centre() const { return {left + width / 2, top + height / 2}; }
  /// Its border counts.
  [[nodiscard]] bool holds(const Point& p) const {
    return p.x >= left && p.x <= right() && p.y >= top && p.y <= bottom();
  }
};

enum class Pattern { solid, dashed, dotted };
struct PixelLine {
  Role role = Role::text;
  std::vector<Point> points{};
  double width = 1.5;
  Pattern pattern = Pattern::solid;
};
/// Polygons in a light tint of their role's colour, all filled together by the even-odd rule.
struct Area {
  Role role = Role::surface;
  std::vector<std::vector<Point>> rings{};
};
/// One shape a role: a dot begins the ray, a ring is exact, a cross is claimed, a diamond is the nearest
/// point.
enum class MarkShape { dot, ring, cross, diamond };
struct Mark {
  Role role = Role::text;
  MarkShape shape = MarkShape::dot;
  Point at{};
};
enum class Anchor { start, middle, end };
/// `at` is the anchor on the baseline. A halo of the background's colour keeps it legible over lines.
struct Text {
  Role role = Role::text;
  Point at{};
  std::string text{};
  Anchor anchor = Anchor::start;
  double size = 14;
  bool bold = false;
  bool halo = false;
};
using Element = std::variant<Area, PixelLine, Mark, Text>;

/// Elements in the order of painting.
struct Picture {
  double width = 900;
  double height = 480;
  std::string title{};        ///< one line, for screen readers and the window's title
  std::string description{};  ///< the same as a sentence or two
  std::vector<Element> elements{};
};

/// With minus signs where a hyphen stands for one: "n·(p - o) = -3.5", but not in "half-open" nor "1e-4".
[[nodiscard]] std::string typeset(const std::string& text);

/// Writes a line of text into a picture.
inline void add_text(Picture& picture, Role role, const Point& at, const std::string& text, double size,
                     bool is_bold = false, Anchor anchor = Anchor::start) {
  picture.elements.emplace_back(Text{role, at, typeset(text), anchor, size, is_bold});
}
/// Draws a line around a box.
inline void add_frame(Picture& picture, Role role, const PixelBox& b, double width) {
  const Point low{b.left, b.bottom()}, high{b.right(), b.top};
  picture.elements.emplace_back(PixelLine{role, {low, {low.x, high.y}, high, {high.x, low.y}, low}, width});
}

/// How far marks reach from their centre.
inline constexpr double mark_radius = 6;

/// A part of a line that stands on one height.
struct TextRun {
  std::string text;
  bool is_low = false;  ///< an index: smaller, and below the baseline
};
/// In em of the line's text: an index's size, and how far its baseline lies below the line's.
inline constexpr double low_size = 0.72;
inline constexpr double low_drop = 0.16;

/// The runs of a line: letters and digits that follow a letter and "_" are an index, without the "_".
[[nodiscard]] std::vector<TextRun> runs_of(const std::string& line);

}  // namespace rayproof::viz
