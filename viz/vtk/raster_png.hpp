#pragma once
/// \file
/// VTK as reader and writer of pixels.

#include <string>

#include "viz/picture/raster.hpp"

class vtkImageData;
class vtkRenderWindow;
template <class T>
class vtkSmartPointer;

namespace rayproof::viz {

/// As VTK has pixels, of three bytes each; its first row is the lowest.
[[nodiscard]] vtkSmartPointer<vtkImageData> image_of(const Raster& raster);

/// Renders the window at its size. Needs a display (OffscreenDisplay, UserDisplay).
[[nodiscard]] Raster pixels_of(vtkRenderWindow& window);

/// Writes the pixels as an RGB PNG; needs no display. Throws std::runtime_error with one sentence where the
/// file can't be written.
void write_png(const Raster& raster, const std::string& path);

}  // namespace rayproof::viz
