#pragma once
/// \file
/// Pictures of one scene's light by several strategies, side by side.

#include <string>
#include <vector>

#include "viz/picture/raster.hpp"

namespace rayproof::render {

/// One panel of the figure, all of one size.
struct ShadowPanel {
  std::string title{};
  viz::Raster picture{};
};

/// The panels, three in a row, each under its title, and what the colours mean below. Needs a display
/// (viz::OffscreenDisplay).
[[nodiscard]] viz::Raster shadow_figure(const std::vector<ShadowPanel>& panels);

}  // namespace rayproof::render
