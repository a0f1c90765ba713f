#pragma once
/// \file
/// A step's scene as a still picture in a page.

#include <cstddef>
#include <string>

#include "viz/scene/stage.hpp"
#include "viz/vtk/picture_png.hpp"

namespace rayproof::viz {

/// An off-screen window in which stills are drawn one after another. Needs a display (OffscreenDisplay) that
/// outlives it.
class StillCanvas {
 public:
  /// An `<img>` with the picture in it; its text for screen readers is the step's caption.
  [[nodiscard]] std::string still(const Stage& stage, std::size_t step);

 private:
  PictureCanvas canvas_{};
};

}  // namespace rayproof::viz
