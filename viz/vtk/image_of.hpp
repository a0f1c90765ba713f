#pragma once
/// \file
/// Pixels as VTK has them.

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include "viz/picture/raster.hpp"

namespace rayproof::viz {

/// Of three bytes a pixel; VTK's first row is the lowest.
[[nodiscard]] vtkSmartPointer<vtkImageData> image_of(const Raster& raster);

}  // namespace rayproof::viz
