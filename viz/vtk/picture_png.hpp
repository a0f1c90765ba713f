#pragma once
/// \file
/// VTK as a sink of pictures, and of the scenes in them.

#include <cstddef>
#include <memory>
#include <vector>

#include "viz/picture/picture.hpp"
#include "viz/picture/raster.hpp"
#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// Pixels of the PNG for each of the picture's: sharp on paper and on dense screens.
inline constexpr int png_scale = 2;

/// A step of a stage, to be drawn in true space in a frame of a picture.
struct Inlay {
  const Stage* stage;
  std::size_t step;
  PixelBox frame;
};

/// An off-screen window in which pictures are drawn one after another, in their light colours: to open one
/// takes longer than to draw in it. Needs a display (OffscreenDisplay) that outlives it.
class PictureCanvas {
 public:
  PictureCanvas();
  ~PictureCanvas();
  PictureCanvas(const PictureCanvas&) = delete;
  PictureCanvas& operator=(const PictureCanvas&) = delete;

  /// The pixels of the picture at `scale` times its size: its scenes, their labels, and over them its own
  /// elements. Scenes that need not be drawn with care take half the time.
  [[nodiscard]] Raster draw(const Picture& picture, const std::vector<Inlay>& scenes = {},
                            double scale = png_scale, bool is_fine = true);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rayproof::viz
