#pragma once
/// \file
/// VTK as a sink of pictures.

#include <memory>
#include <string>

#include "viz/picture/picture.hpp"
#include "viz/picture/raster.hpp"

namespace rayproof::viz {

/// Pixels of the PNG for each of the picture's: sharp on paper and on dense screens.
inline constexpr int png_scale = 2;

/// An off-screen window in which pictures are drawn one after another, in their light colours: to open one
/// takes longer than to draw in it. Needs a display (OffscreenDisplay) that outlives it.
class PictureCanvas {
 public:
  PictureCanvas();
  ~PictureCanvas();
  PictureCanvas(const PictureCanvas&) = delete;
  PictureCanvas& operator=(const PictureCanvas&) = delete;

  /// Writes the picture as a PNG of `scale` times its size. Throws std::runtime_error with one sentence where
  /// the file can't be written.
  void write(const Picture& picture, const std::string& path, double scale = png_scale);
  /// The pixels of the same.
  [[nodiscard]] Raster draw(const Picture& picture, double scale = png_scale);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rayproof::viz
