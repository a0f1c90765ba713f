#pragma once
/// \file
/// A step of a stage as a picture: the scene alone, for a page, or a whole slide with title, numbers and
/// legend.

#include <cstddef>
#include <vector>

#include "viz/explain/case_report.hpp"
#include "viz/picture/picture.hpp"
#include "viz/scene/shown_items.hpp"
#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// How many pixels a length has in a frame that shows a view.
[[nodiscard]] double pixels_per_length(const StageView& view, const PixelBox& frame);

/// Draws a step's scene into a frame of a picture, its own items bright and those of the steps before dimmed.
void draw_scene(Picture& picture, const PixelBox& frame, const Stage& stage, std::size_t step);
[[nodiscard]] Picture scene_picture(const Stage& stage, std::size_t step, double width, double height);

/// A slide's size, and what stays free along its border.
inline constexpr double slide_width = 960, slide_height = 540, slide_margin = 24;
/// Where a slide's scene lies beside a column of numbers.
inline constexpr PixelBox slide_scene{slide_margin, 60, 596, 368};
/// Where it lies in the step's slide: without numbers it has the column's place, too.
[[nodiscard]] PixelBox slide_scene_of(const StageStep& step);

/// A slide without its scene and legend: the title, a smaller line below it, the caption, and beside the
/// scene's frame the numbers.
[[nodiscard]] Picture slide_frame(const Stage& stage, std::size_t number, const std::string& second_line,
                                  const PixelBox& scene);

/// The words on the roles, along a slide's lower border.
void draw_legend(Picture& picture, const Stage& stage, std::size_t step);

struct LegendEntry {
  Role role;
  bool is_mark;  ///< a mark, else a line
  const char* text;
};
/// The words on the roles that are among the items of a stage.
[[nodiscard]] std::vector<LegendEntry> legend_of(const Stage& stage, const std::vector<ShownItem>& shown);

/// The mark, or a short line, around a place.
[[nodiscard]] Element legend_sign(const LegendEntry& entry, const Point& at);

/// Below each name of the step the rounded number, the exact one, and the bits lost where they are worth a
/// word; as high as the scene.
void draw_values(Picture& picture, const Stage& stage, const StageStep& step, const PixelBox& scene);

/// The text's first line of that width, and "…" where there are more.
[[nodiscard]] std::string cut(const std::string& text, double width, double size);

using WorldLine = std::vector<glm::dvec3>;

struct SurfaceOutline {
  std::vector<WorldLine> filled{};  ///< rings; the even-odd rule fills them
  std::vector<WorldLine> seen{};
  std::vector<WorldLine> hidden{};
};

/// Of a solid its edges and where it turns away from the camera, of an ellipsoid the latter. A polygon has no
/// line around it but what other items draw.
[[nodiscard]] SurfaceOutline surface_outline(const StageItem& surface, const StageCamera& camera);

/// All but the scenes: a headline, a frame for each view, and a table of the answers below them.
struct CaseSheet {
  Stage stage{};                   ///< its steps are the views (viz/walkthrough/lesson.hpp)
  std::vector<PixelBox> frames{};  ///< where each is to be drawn
  Picture picture{};
};
[[nodiscard]] CaseSheet case_sheet(const CaseReport& report);

/// The same with the scenes drawn flat, each with a scale: what SVG shows. Never throws for a valid case,
/// whatever the answers' numbers.
[[nodiscard]] Picture case_picture(const CaseReport& report);

}  // namespace rayproof::viz
