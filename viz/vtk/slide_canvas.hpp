#pragma once
/// \file
/// Slides: a step of a walkthrough in true space, with its title, numbers and caption; stills of them in
/// pages, and films.

#include <cstddef>
#include <string>
#include <vector>

#include "viz/picture/raster.hpp"
#include "viz/scene/stage.hpp"
#include "viz/vtk/picture_png.hpp"

class vtkOggTheoraWriter;

namespace rayproof::viz {

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
