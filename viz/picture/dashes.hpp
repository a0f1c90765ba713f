#pragma once
/// \file
/// Line patterns for sinks that have none of their own.

#include <vector>

#include "viz/picture/picture.hpp"

namespace rayproof::viz {

/// The strokes of a line in its pattern; the line itself where it is solid.
[[nodiscard]] std::vector<std::vector<Point>> dashes_of(const PixelLine& line);

}  // namespace rayproof::viz
