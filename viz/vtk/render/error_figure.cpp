#include "viz/vtk/render/error_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "viz/render/errors.hpp"
#include "viz/vtk/picture_png.hpp"

namespace rayproof::render {

namespace {

using viz::Picture;
using viz::Raster;
using viz::Role;

/// Device pixels that VTK draws at most.
constexpr double widest = 8192;

Rgb colour_of(const ErrorImage& errors, std::size_t i, int device_x, int device_y) {
  const Verdict verdict = errors.verdicts[i];
  if (verdict == Verdict::miss) return background;
  if (verdict == Verdict::hit) return ulp_colours[step_of(errors.ulps[i])];
  const auto* style =
      std::ranges::find_if(verdict_styles, [&](const VerdictStyle& s) { return s.verdict == verdict; });
  return hatched(*style, device_x, device_y);
}

int in_device(double length) { return static_cast<int>(length * png_scale); }

/// Paints the pixels of a box at a place of the picture, as far as they are on the canvas.
template <class ColourAt>
void paint(Raster& canvas, const viz::Point& at, int width, int height, ColourAt&& colour_at) {
  const int left = in_device(at.x), top = in_device(at.y);
  for (int y = 0; y < height && top + y < canvas.height; ++y)
    for (int x = 0; x < width && left + x < canvas.width; ++x) canvas.at(left + x, top + y) = colour_at(x, y);
}

void paint_swatch(Raster& canvas, const Swatch& swatch) {
  const int width = in_device(swatch_width), height = in_device(swatch_height);
  paint(canvas, {margin, swatch.top}, width, height, [&](int x, int y) {
    const bool is_rim = x < 2 || y < 2 || x >= width - 2 || y >= height - 2;
    return is_rim ? rgb_of("#5a626c") : swatch.colour(x, y);
  });
}

constexpr std::size_t most_in_row = 3;
// In the picture's own pixels, png_scale device pixels each.
constexpr double space = 16, title_height = 22;

}  // namespace

void check_size(const std::vector<ErrorPanel>& panels) {
  const ErrorLayout layout(panels);
  if (layout.width * png_scale > widest || layout.panel_height * png_scale > widest) {
    throw std::runtime_error(
        fmt::format("{} of {}x{} pixels are too large for one error image, which may have {} on a side",
                    panels.size() == 1 ? "errors" : "two images", panels.front().errors.width,
                    panels.front().errors.height, widest));
  }
}

Raster error_figure(const std::string& title, const std::vector<ErrorPanel>& panels) {
  check_size(panels);
  const ErrorLayout layout(panels);
  Picture picture;
  picture.width = layout.width;
  add_text(picture, Role::text, {margin, margin + 14}, title, 16, true);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double left = layout.panel_left(i);
    double baseline = margin + row_height + 18;
    for (const std::string& line : layout.titles[i]) {
      add_text(picture, Role::text, {left, baseline}, line, letter_size);
      baseline += row_height;
    }
    add_frame(picture, Role::frame,
              {left - 1, layout.panels_top - 1, layout.panel_width + 2, layout.panel_height + 2}, 1.5);
  }
  const std::vector<Swatch> swatches =
      write_legend(picture, panels, layout.panels_top + layout.panel_height + 14);

  Raster canvas = viz::PictureCanvas().draw(picture);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const ErrorImage& errors = panels[i].errors;
    const int zoom = layout.zoom;
    paint(canvas, {layout.panel_left(i), layout.panels_top}, errors.width * zoom, errors.height * zoom,
          [&](int x, int y) {
            return colour_of(errors, viz::pixel_index(errors.width, x / zoom, y / zoom), x, y);
          });
  }
  for (const Swatch& swatch : swatches) paint_swatch(canvas, swatch);
  return canvas;
}

viz::Raster shadow_figure(const std::vector<ShadowPanel>& panels) {
  const double width = static_cast<double>(panels.front().picture.width) / viz::png_scale;
  const double height = static_cast<double>(panels.front().picture.height) / viz::png_scale;
  const auto in_row = static_cast<double>(std::min(most_in_row, panels.size()));
  const auto rows = static_cast<double>((panels.size() + most_in_row - 1) / most_in_row);
  const auto left_of = [&](std::size_t i) {
    return space + static_cast<double>(i % most_in_row) * (width + space);
  };
  const auto top_of = [&](std::size_t i) {
    return space + title_height + static_cast<double>(i / most_in_row) * (height + title_height + space);
  };
  viz::Picture picture;
  picture.width = space + in_row * (width + space);
  picture.height = space + rows * (height + title_height + space) + title_height;
  for (std::size_t i = 0; i < panels.size(); ++i)
    add_text(picture, viz::Role::text, {left_of(i), top_of(i) - 8}, panels[i].title, 11, true);
  add_text(picture, viz::Role::text, {space, picture.height - 12},
           "red: acne, dark though the light is seen; yellow: a leak, lit through something", 11);
  viz::Raster canvas = viz::PictureCanvas().draw(picture);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const viz::Raster& shown = panels[i].picture;
    paint(canvas, {left_of(i), top_of(i)}, shown.width, shown.height,
          [&](int x, int y) { return shown.at(x, y); });
  }
  return canvas;
}

}  // namespace rayproof::render
