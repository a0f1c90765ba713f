#pragma once
/// \file
/// A step's scene as a still picture in a page.

#include <cstddef>
#include <memory>
#include <string>

#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// An off-screen window in which stills are drawn one after another. Needs a display (OffscreenDisplay) that
/// outlives it.
class StillCanvas {
 public:
  StillCanvas();
  ~StillCanvas();
  StillCanvas(const StillCanvas&) = delete;
  StillCanvas& operator=(const StillCanvas&) = delete;

  /// An `<img>` with the picture in it; its text for screen readers is the step's caption.
  [[nodiscard]] std::string still(const Stage& stage, std::size_t step);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rayproof::viz
