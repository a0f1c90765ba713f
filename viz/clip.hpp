#pragma once
/// \file
/// Clipping to a box in pixels.

#include <vector>

#include "viz/picture.hpp"

namespace rayproof::viz {

/// The parts of a polyline inside the box.
[[nodiscard]] std::vector<std::vector<Point>> clip_line(const std::vector<Point>& line, const Box& box);

/// The part of a convex polygon inside the box; empty where they do not meet.
[[nodiscard]] std::vector<Point> clip_area(std::vector<Point> area, const Box& box);

}  // namespace rayproof::viz
