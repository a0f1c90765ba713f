#pragma once
/// \file
/// Errors as pictures: images with their legend and totals, side by side on one scale; the same in a window
/// of VTK's, whose pixels can be clicked; and a method's errors over a surface, as colours on it.

#include <algorithm>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "viz/picture/picture.hpp"
#include "viz/picture/raster.hpp"
#include "viz/render/errors.hpp"
#include "viz/vtk/picture_png.hpp"

class vtkRenderWindow;
class vtkRenderWindowInteractor;

namespace rayproof::render {

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

struct ShadowPanel {
  std::string title{};
  viz::Raster picture{};
};

/// The panels, three in a row, each under its title, and what the colours mean below. Needs a display
/// (viz::OffscreenDisplay).
[[nodiscard]] viz::Raster shadow_figure(const std::vector<ShadowPanel>& panels);

using viz::png_scale;

// All lengths are in the picture's own pixels, png_scale device pixels each.
inline constexpr double margin = 20, gap = 24, row_height = 22, swatch_width = 34, swatch_height = 15;
inline constexpr double label_width = 300, count_width = 170, least_width = 560;
/// Small images are magnified by a whole number to this or more, so that single pixels can be seen.
inline constexpr int least_panel = 420;
/// Of the letters of titles and legend.
inline constexpr double letter_size = 14;

struct PanelPixel {
  std::size_t panel = 0;
  int x = 0, y = 0;
};

struct ErrorLayout {
  int columns, rows;  ///< of an image
  int zoom;           ///< device pixels for one of the image's
  double panel_width, panel_height, panels_top;
  double width;
  std::vector<std::vector<std::string>> titles{};  ///< the lines above each panel

  explicit ErrorLayout(const std::vector<ErrorPanel>& panels);

  [[nodiscard]] double panel_left(std::size_t i) const {
    return margin + static_cast<double>(i) * (panel_width + gap);
  }
  /// What a device pixel of the figure shows; nothing beside the panels.
  [[nodiscard]] std::optional<PanelPixel> pixel_at(double x, double y) const;
};

[[nodiscard]] inline double count_right(std::size_t i) {
  return margin + swatch_width + 10 + label_width + static_cast<double>(i + 1) * count_width;
}

/// A swatch of the legend, to be painted once the picture is pixels.
struct Swatch {
  double top;
  std::function<viz::Rgb(int, int)> colour;
};

/// Writes the legend and each panel's totals into the picture from `top` on, and gives back its swatches; the
/// picture becomes as high as that takes.
[[nodiscard]] std::vector<Swatch> write_legend(viz::Picture& picture, const std::vector<ErrorPanel>& panels,
                                               double top);

/// The window is made with the object and gone with it. A UserDisplay (viz/vtk/offscreen_display.hpp) or an
/// OffscreenDisplay must be there before.
///
/// A click on a pixel of a panel opens it, a drag shifts the figure, the wheel comes nearer and goes farther,
/// q ends it.
class ErrorWindow {
 public:
  /// What a click does with a pixel; it gives back a word on it for the window's title.
  using Open = std::function<std::string(const PanelPixel&)>;

  ErrorWindow(const viz::Raster& figure, const ErrorLayout& layout, Open open);
  ~ErrorWindow();
  ErrorWindow(const ErrorWindow&) = delete;
  ErrorWindow& operator=(const ErrorWindow&) = delete;

  /// Until the user quits or closes the window.
  void run();
  /// Hands out all events that have come.
  void handle_events();

  [[nodiscard]] vtkRenderWindow& window();
  [[nodiscard]] vtkRenderWindowInteractor& interactor();
  /// Where the figure's pixel is seen in the window, y up, as VTK's events have it.
  [[nodiscard]] viz::Point to_window(const viz::Point& pixel) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// How far off a ray's answer is that is aimed at a place of the surface, in ulps; negative where its verdict
/// is wrong.
using ErrorAt = std::function<double(const glm::dvec3& place)>;

struct HeatWords {
  std::string title{};
  std::string caption{};
};

struct HeatTotals {
  std::size_t rays = 0;
  std::size_t wrong = 0;
  double worst_ulps = 0;  ///< where the verdict is right
};

/// Whether a shape's surface can be shown so: a sphere's or a triangle's.
[[nodiscard]] bool has_heat_map(const Shape& shape);

/// The surface in 1600 by 900 pixels, seen from near the eye; the side of a sphere that the eye does not see
/// stays grey. One ray is asked for each of its small faces. `words` is asked once all errors are known.
/// Needs a display (viz::OffscreenDisplay).
[[nodiscard]] viz::Raster heat_map(const Shape& shape, const glm::dvec3& eye, const ErrorAt& error_at,
                                   const std::function<HeatWords(const HeatTotals&)>& words);

}  // namespace rayproof::render
