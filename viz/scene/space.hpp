#pragma once
/// \file
/// A step in true space as plain data, ready to be built: what VTK's slides and the pages' script both read.

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "viz/scene/shown_items.hpp"
#include "viz/scene/space_camera.hpp"
#include "viz/scene/space_floor.hpp"
#include "viz/scene/stage.hpp"

namespace rayproof::viz {

using SpacePoints = std::vector<glm::dvec3>;

/// A cone at an arrow's end.
struct ArrowHead {
  glm::dvec3 base{};
  glm::dvec3 tip{};
  double radius = 0;
};

/// An item as it is built. All coordinates and lengths are of the view: its centre is 0, its radius 1.
struct SpaceBody {
  ShownItem shown;
  SpacePoints points{};               ///< of a mark its place, of a surface what its form says
  std::vector<SpacePoints> pieces{};  ///< of a line: the polylines to draw, its dashes or dots
  std::optional<ArrowHead> head{};
  /// Of a polygon that crosses itself the inside by the even-odd rule, in pieces of four corners.
  std::vector<SpacePoints> strips{};
  double radius = 0;   ///< of the lines' tubes, of the mark, of the line around a surface; 0 for none
  double opacity = 1;  ///< of a surface

  [[nodiscard]] bool is_mark() const { return shown.item->form == Form::point; }
  [[nodiscard]] bool is_surface() const { return !is_mark() && pieces.empty(); }
};

/// A label and where it belongs: at a point, or along a line, then best in its middle or at its end.
struct SpaceLabel {
  ShownItem shown;
  SpacePoints points{};
  bool is_at_end = false;
};

/// What marks look like beside their radius: a dot, a ring and its wire, a cross's arm, a diamond's corner. A
/// cross reaches beyond a dot behind it, and leaves a gap to a ring around it.
struct MarkMeasures {
  double dot = 0.8;
  double ring = 2;
  double wire = 0.26;
  double cross = 1;
  double diamond = 1.7;
};
inline constexpr MarkMeasures mark_measures{};

/// The width of what shows the slider's point, in the camera's units.
inline constexpr double runner_size = 0.03;

/// What a step shows, in the order of painting. The bodies live as long as the stage.
struct Space {
  StageView view{};
  SpaceCamera camera{};
  std::vector<SpaceBody> bodies{};
  std::vector<SpaceLabel> labels{};   ///< the newest first
  std::optional<SpaceFloor> floor{};  ///< none below a drawing in a plane
};

/// For a frame `aspect` times as wide as high. What is out of reach is left out; lines are cut there.
[[nodiscard]] Space space_of(const Stage& stage, std::size_t step, double aspect = view_aspect);

/// The item's points in the view's coordinates, without repetitions.
[[nodiscard]] SpacePoints placed_points(const StageItem& item, const StageView& view);

/// The pieces of a line in its pattern, whose lengths go with the radius of its tube.
[[nodiscard]] std::vector<SpacePoints> pieces_of(const SpacePoints& line, double radius, Pattern pattern);

}  // namespace rayproof::viz
