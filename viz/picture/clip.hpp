#pragma once
/// \file
/// Cutting lines and areas: at a frame, and a polygon that crosses itself into what it fills.

#include <array>
#include <vector>

#include "viz/picture/picture.hpp"

namespace rayproof::viz {

/// The parts of a line inside the box.
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
