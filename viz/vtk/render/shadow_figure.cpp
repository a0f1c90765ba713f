#include "viz/vtk/render/error_figure.hpp"

#include <algorithm>

#include "viz/vtk/picture_png.hpp"

namespace rayproof::render {
namespace {

constexpr std::size_t columns = 3;
// In the picture's own pixels, png_scale device pixels each.
constexpr double space = 16, title_height = 22;

void paint(viz::Raster& canvas, const viz::Raster& picture, int left, int top) {
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      if (left + x < canvas.width && top + y < canvas.height) canvas.at(left + x, top + y) = picture.at(x, y);
}

}  // namespace

viz::Raster shadow_figure(const std::vector<ShadowPanel>& panels) {
  const double width = static_cast<double>(panels.front().picture.width) / viz::png_scale;
  const double height = static_cast<double>(panels.front().picture.height) / viz::png_scale;
  const auto in_row = static_cast<double>(std::min(columns, panels.size()));
  const auto rows = static_cast<double>((panels.size() + columns - 1) / columns);
  const auto left_of = [&](std::size_t i) {
    return space + static_cast<double>(i % columns) * (width + space);
  };
  const auto top_of = [&](std::size_t i) {
    return space + title_height + static_cast<double>(i / columns) * (height + title_height + space);
  };
  viz::Picture picture;
  picture.width = space + in_row * (width + space);
  picture.height = space + rows * (height + title_height + space) + title_height;
  for (std::size_t i = 0; i < panels.size(); ++i)
    add_text(picture, viz::Role::text, {left_of(i), top_of(i) - 8}, panels[i].title, 11, true);
  add_text(picture, viz::Role::text, {space, picture.height - 12},
           "red: acne, dark though the light is seen; yellow: a leak, lit through something", 11);
  viz::Raster canvas = viz::PictureCanvas().draw(picture);
  for (std::size_t i = 0; i < panels.size(); ++i)
    paint(canvas, panels[i].picture, static_cast<int>(left_of(i) * viz::png_scale),
          static_cast<int>(top_of(i) * viz::png_scale));
  return canvas;
}

}  // namespace rayproof::render
