#pragma once
/// \file
/// Slides: a step of a walkthrough in true space, with its title, numbers and caption.

#include <memory>
#include <vector>

#include "viz/picture/raster.hpp"
#include "viz/scene/stage.hpp"

namespace rayproof::viz {

class SlideView;

/// An off-screen window in which slides are drawn one after another. Needs a display (OffscreenDisplay) that
/// outlives it.
class SlideCanvas {
 public:
  SlideCanvas();
  ~SlideCanvas();
  SlideCanvas(const SlideCanvas&) = delete;
  SlideCanvas& operator=(const SlideCanvas&) = delete;

  /// The step in 1600 by 900 pixels.
  [[nodiscard]] Raster draw(const Stage& stage, std::size_t step);

 private:
  std::unique_ptr<SlideView> view_;
};

/// Slides side by side, at half their size, all of one size.
[[nodiscard]] Raster contact_sheet(const std::vector<Raster>& slides);

}  // namespace rayproof::viz
