#pragma once
/// \file
/// Error images with their legend and totals, side by side on one scale.

#include <string>
#include <vector>

#include "viz/picture/raster.hpp"
#include "viz/render/errors.hpp"

namespace rayproof::render {

/// One panel of the figure.
struct ErrorPanel {
  std::string title{};  ///< the methods
  ErrorImage errors{};
};

/// Throws std::runtime_error with one sentence where panels of this number and size are too large for one
/// figure.
void check_size(const std::vector<ErrorPanel>& panels);

/// The panels beside each other, the legend with each panel's counts below. Needs a display
/// (viz::OffscreenDisplay).
[[nodiscard]] viz::Raster error_figure(const std::string& title, const std::vector<ErrorPanel>& panels);

/// One panel of the figure, all of one size.
struct ShadowPanel {
  std::string title{};
  viz::Raster picture{};
};

/// The panels, three in a row, each under its title, and what the colours mean below. Needs a display
/// (viz::OffscreenDisplay).
[[nodiscard]] viz::Raster shadow_figure(const std::vector<ShadowPanel>& panels);

}  // namespace rayproof::render
