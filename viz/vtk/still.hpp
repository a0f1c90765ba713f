#pragma once
/// \file
/// A step's scene as a still picture in a page.

#include <cstddef>
#include <string>

#include "viz/scene/stage.hpp"
#include "viz/vtk/picture_png.hpp"

namespace rayproof::viz {

/// An `<img>` with the picture in it, drawn by the canvas; its text for screen readers is the step's caption.
[[nodiscard]] std::string still_of(PictureCanvas& canvas, const Stage& stage, std::size_t step);

}  // namespace rayproof::viz
