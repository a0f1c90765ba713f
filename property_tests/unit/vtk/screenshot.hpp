#pragma once
/// \file
/// What a window shows, pixel by pixel.

#include "viz/picture/picture.hpp"
#include "viz/vtk/picture_png.hpp"
#include "viz/vtk/window/stage_window.hpp"

namespace rayproof::viz {

/// The picture of a window at rest; asked in the pixels of a slide.
class Screenshot {
 public:
  explicit Screenshot(StageWindow& window) : window_(window) {
    window.repaint();
    image_ = pixels_of(window.window());
  }

  /// How many of the window's pixels in a box are not white.
  [[nodiscard]] int ink(const PixelBox& box) const {
    return count(box, [&](int x, int y) { return image_.at(x, y) != Rgb{255, 255, 255}; });
  }
  /// How many are not as they are in another screenshot of the same size.
  [[nodiscard]] int changes(const Screenshot& other, const PixelBox& box) const {
    return count(box, [&](int x, int y) { return image_.at(x, y) != other.image_.at(x, y); });
  }
  /// The share of a box's pixels of about the hue of a role's colour: their differences between red, green
  /// and blue have the signs of the colour's, and this share of their size at least: a solid covers 0.2 of
  /// what is behind it, and its faces are lit to 0.7 or more.
  [[nodiscard]] double share_of(Role role, const PixelBox& box, double opacity = 0.2 * 0.7) const {
    const Rgb colour = rgb_of(colour_of(role).light);
    const auto differs_alike = [&](const Rgb& pixel, std::size_t i, std::size_t j) {
      const double wanted = opacity * (colour[i] - colour[j]);
      const double is = pixel[i] - pixel[j];
      return wanted >= 0 ? is >= wanted : is <= wanted;
    };
    const int all = count(box, [](int, int) { return true; });
    const int alike = count(box, [&](int x, int y) {
      const Rgb& pixel = image_.at(x, y);
      return differs_alike(pixel, 0, 1) && differs_alike(pixel, 1, 2) && differs_alike(pixel, 0, 2);
    });
    return static_cast<double>(alike) / all;
  }

 private:
  template <class Holds>
  [[nodiscard]] int count(const PixelBox& box, Holds&& is_counted) const {
    const Point low = window_.to_window({box.left, box.bottom()});
    const Point high = window_.to_window({box.right(), box.top});
    int sum = 0;
    for (int y = std::max(0, static_cast<int>(low.y)); y < std::min<double>(high.y, image_.height); ++y) {
      for (int x = std::max(0, static_cast<int>(low.x)); x < std::min<double>(high.x, image_.width); ++x)
        sum += is_counted(x, image_.height - 1 - y) ? 1 : 0;
    }
    return sum;
  }

  StageWindow& window_;
  Raster image_{};
};

}  // namespace rayproof::viz
