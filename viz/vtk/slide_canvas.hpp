#pragma once
/// \file
/// Slides: a step of a walkthrough in true space, with its title, numbers and caption.

#include <cstddef>
#include <string>
#include <vector>

#include "viz/picture/raster.hpp"
#include "viz/scene/stage.hpp"
#include "viz/vtk/picture_png.hpp"

namespace rayproof::viz {

/// An off-screen window in which slides are drawn one after another. Needs a display (OffscreenDisplay) that
/// outlives it.
class SlideCanvas {
 public:
  /// Pictures of this width, 16 by 9.
  explicit SlideCanvas(int width = 1600) : width_(width) {}

  /// The step; where it need not be drawn with care, in half the time.
  [[nodiscard]] Raster draw(const Stage& stage, std::size_t step, bool is_fine = true);

 private:
  int width_;
  PictureCanvas canvas_{};
};

/// Slides side by side, at half their size, all of one size.
[[nodiscard]] Raster contact_sheet(const std::vector<Raster>& slides);

/// An `<img>` with the picture in it, drawn by the canvas; its text for screen readers is the step's caption.
[[nodiscard]] std::string still_of(PictureCanvas& canvas, const Stage& stage, std::size_t step);

}  // namespace rayproof::viz
