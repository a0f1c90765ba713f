#pragma once
/// \file
/// VTK as reader and writer of pixels, as a sink of pictures and of the scenes in them: slides, stills of
/// them in pages, and films.

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "viz/picture/picture.hpp"
#include "viz/picture/raster.hpp"
#include "viz/scene/stage.hpp"

class vtkImageData;
class vtkRenderWindow;
template <class T>
class vtkSmartPointer;
class vtkOggTheoraWriter;

namespace rayproof::viz {

/// As VTK has pixels, of three bytes each; its first row is the lowest.
[[nodiscard]] vtkSmartPointer<vtkImageData> image_of(const Raster& raster);

/// Renders the window at its size. Needs a display (OffscreenDisplay, UserDisplay).
[[nodiscard]] Raster pixels_of(vtkRenderWindow& window);

/// Writes the pixels as an RGB PNG; needs no display. Throws std::runtime_error with one sentence where the
/// file can't be written.
void write_png(const Raster& raster, const std::string& path);

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

/// The step as a slide of this width, 16 by 9; where it need not be drawn with care, in half the time.
[[nodiscard]] Raster draw_slide(PictureCanvas& canvas, const Stage& stage, std::size_t step,
                                double width = 1600, bool is_fine = true);

/// Slides side by side, at half their size, all of one size.
[[nodiscard]] Raster contact_sheet(const std::vector<Raster>& slides);

/// An `<img>` with the picture in it, drawn by the canvas; its text for screen readers is the step's caption.
[[nodiscard]] std::string still_of(PictureCanvas& canvas, const Stage& stage, std::size_t step);

/// An Ogg file with Theora video and no sound. It is whole once the object is gone.
class Movie {
 public:
  /// `rate` pictures a second.
  Movie(const std::string& path, int rate);
  ~Movie();
  Movie(const Movie&) = delete;
  Movie& operator=(const Movie&) = delete;

  /// Adds a picture, `count` times; all must be of one size. Throws std::runtime_error with one sentence
  /// where it can't be written.
  void add(const Raster& picture, int count);

 private:
  std::string path_;
  bool is_begun_ = false;
  vtkOggTheoraWriter* writer_;
};

}  // namespace rayproof::viz
