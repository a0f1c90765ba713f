#pragma once
/// \file
/// VTK as reader and writer of pixels.

#include <string>

#include "viz/picture.hpp"
#include "viz/raster.hpp"

namespace rayproof::viz {

/// Writes the pixels as an RGB PNG; needs no display. Throws std::runtime_error with one sentence where the
/// file can't be written.
void write_png(const Raster& raster, const std::string& path);

/// Draws the picture in its light colours, png_scale pixels for each of its own. Needs a display
/// (OffscreenDisplay).
[[nodiscard]] Raster draw_picture(const Picture& picture);

}  // namespace rayproof::viz
