#pragma once
/// \file
/// VTK as a writer of films.

#include <string>

#include "viz/picture/raster.hpp"

class vtkOggTheoraWriter;

namespace rayproof::viz {

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
