#pragma once
/// \file
/// VTK as reader and writer of pixels.

#include <string>

#include "viz/picture/raster.hpp"

namespace rayproof::viz {

/// Writes the pixels as an RGB PNG; needs no display. Throws std::runtime_error with one sentence where the
/// file can't be written.
void write_png(const Raster& raster, const std::string& path);

}  // namespace rayproof::viz
