#pragma once
/// \file
/// A picture as data: lines, areas, marks and text in pixels. SVG is a sink of it, and VTK of what stands
/// over a scene: text, marks and solid lines.

#include <array>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace rayproof::viz {

/// What an element stands for. The sinks give each role one colour, in a light and a dark scheme
/// (`palette`); no meaning rests on colour alone: marks and line patterns differ too.
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

inline void add_text(Picture& picture, Role role, const Point& at, const std::string& text, double size,
                     bool is_bold = false, Anchor anchor = Anchor::start) {
  picture.elements.emplace_back(Text{role, at, typeset(text), anchor, size, is_bold});
}
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

struct RoleColour {
  const char* name;   ///< CSS class
  const char* light;  ///< on white, #rrggbb
  const char* dark;   ///< on near-black
};

/// One colour for each role, in their order: safe for colour-blind readers (M. Okabe, K. Ito, "Color
/// Universal Design", 2008), darkened or lightened where needed to contrast 4.5:1 or more as text, and as a
/// label's large text 3:1 or more before a surface.
inline constexpr std::array<RoleColour, role_count> palette{{
    {"background", "#ffffff", "#16181c"},
    {"frame", "#b8bec6", "#4a515c"},
    {"text", "#16181c", "#e8eaed"},
    {"muted", "#4a525b", "#a3abb5"},
    {"surface", "#0072b2", "#56b4e9"},
    {"ray", "#16181c", "#e8eaed"},
    {"exact", "#006243", "#2fc99a"},
    {"claimed", "#9a3d00", "#ff8f4d"},
    {"nearest", "#81396a", "#e29ac6"},
    {"normal", "#654a00", "#e8c547"},
    {"edge", "#00527f", "#8ecbf0"},
}};

[[nodiscard]] constexpr const RoleColour& colour_of(Role role) {
  return palette[static_cast<std::size_t>(role)];
}

struct FloorColours {
  RoleColour ground{"ground", "#f4f5f7", "#1d2026"};
  RoleColour grid{"grid", "#d1d6de", "#343a44"};
  RoleColour shadow{"shadow", "#d6dbe0", "#0e1013"};
};
inline constexpr FloorColours floor_colours{};

/// How much of the colour an area's tint keeps.
inline constexpr double area_opacity = 0.13;

/// One `<svg>` element. The text is self-contained (no font, script, style or address from elsewhere),
/// follows the reader's light or dark scheme, scales to the width of the element it is put into, and bears a
/// `<title>` and a `<desc>` for screen readers. As a file of its own, put xml_head before it.
[[nodiscard]] std::string to_svg(const Picture& picture);

/// An element alone, for an `<svg>` that is styled already.
[[nodiscard]] std::string to_svg(const Element& element);

/// How an element within `scope`, a CSS selector, is painted by its classes: l a line, f filled, a an area, h
/// a halo; and the colour of its role, in light and dark.
[[nodiscard]] std::string role_style(const std::string& scope);

inline constexpr const char* xml_head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
[[nodiscard]] std::vector<std::vector<Point>> clip_line(const std::vector<Point>& line, const PixelBox& box);

/// The part of an area inside the box; by the even-odd rule the same is filled there. Nothing of one with a
/// corner at no finite place.
[[nodiscard]] std::vector<Point> clip_area(std::vector<Point> area, const PixelBox& box);

/// Four corners in turn; two of them may be one.
using Strip = std::array<Point, 4>;

/// The inside in level strips; none of a ring no two of whose sides cross, and of one of thousands of sides.
/// Of one that crosses itself thousands of times the strips are fewer, and about the inside.
[[nodiscard]] std::vector<Strip> even_odd_strips(const std::vector<Point>& ring);

}  // namespace rayproof::viz
