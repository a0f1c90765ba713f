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
  /// Pictures of this width, 16 by 9.
  explicit SlideCanvas(int width = 1600);
  ~SlideCanvas();
  SlideCanvas(const SlideCanvas&) = delete;
  SlideCanvas& operator=(const SlideCanvas&) = delete;

  /// The step; where it need not be drawn with care, in half the time.
  [[nodiscard]] Raster draw(const Stage& stage, std::size_t step, bool is_fine = true);

 private:
  std::unique_ptr<SlideView> view_;
};

/// Slides side by side, at half their size, all of one size.
[[nodiscard]] Raster contact_sheet(const std::vector<Raster>& slides);

}  // namespace rayproof::viz
