#pragma once
/// \file
/// VTK as a sink of pictures.

#include <string>

#include "viz/picture.hpp"

namespace rayproof::viz {

/// Pixels of the PNG for each of the picture's: sharp on paper and on dense screens.
inline constexpr int png_scale = 2;

/// Draws the picture in its light colours and writes it as a PNG of `scale` times its size. Needs a display
/// (OffscreenDisplay). Throws std::runtime_error with one sentence where the file can't be written.
void write_picture(const Picture& picture, const std::string& path, double scale = png_scale);

}  // namespace rayproof::viz
