#pragma once
/// \file
/// Clipping to a box in pixels, and to the neighbourhood of a view in the scene.

#include <vector>

#include "viz/drawing/view.hpp"

namespace rayproof::viz {

/// The parts of a polyline inside the box.
[[nodiscard]] std::vector<std::vector<Point>> clip_line(const std::vector<Point>& line, const PixelBox& box);

/// The part of a polygon inside the box; empty where they do not meet. What was concave may come back joined
/// along the box's sides; by the even-odd rule it is the same area.
[[nodiscard]] std::vector<Point> clip_area(std::vector<Point> area, const PixelBox& box);

/// The same for a few frames around what the view shows, in the scene's own numbers: a pixel's can't hold the
/// direction of a line between two points that are both far away.
[[nodiscard]] std::vector<std::vector<WorldPoint>> clip_line_near(const std::vector<WorldPoint>& line,
                                                                  const View& view);
[[nodiscard]] std::vector<WorldPoint> clip_area_near(std::vector<WorldPoint> area, const View& view);

}  // namespace rayproof::viz
