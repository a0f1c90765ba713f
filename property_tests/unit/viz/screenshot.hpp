#pragma once
/// \file
/// What a window shows, pixel by pixel.

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>
#include <vtkWindowToImageFilter.h>

#include <array>
#include <cmath>

#include "viz/vtk/stage_window.hpp"

namespace rayproof::viz {

/// The picture of a window as it is at the time; asked in the pixels of the player's picture.
class Screenshot {
 public:
  explicit Screenshot(StageWindow& window) : window_(window) {
    window.repaint();
    vtkNew<vtkWindowToImageFilter> filter;
    filter->SetInput(&window.window());
    filter->SetInputBufferTypeToRGB();
    filter->ReadFrontBufferOff();
    filter->Update();
    image_ = filter->GetOutput();
  }

  using Colour = std::array<int, 3>;
  [[nodiscard]] Colour at(int x, int y) const {
    const auto* rgb = static_cast<const unsigned char*>(image_->GetScalarPointer(x, y, 0));
    return {rgb[0], rgb[1], rgb[2]};
  }
  [[nodiscard]] int width() const { return image_->GetDimensions()[0]; }
  [[nodiscard]] int height() const { return image_->GetDimensions()[1]; }

  /// How many of the window's pixels in a box of the picture are not white.
  [[nodiscard]] int ink(const PixelBox& box) const {
    return count(box, [&](int x, int y) { return at(x, y) != Colour{255, 255, 255}; });
  }
  /// How many are not as they are in another screenshot of the same size.
  [[nodiscard]] int changes(const Screenshot& other, const PixelBox& box) const {
    return count(box, [&](int x, int y) { return at(x, y) != other.at(x, y); });
  }

 private:
  template <class Holds>
  [[nodiscard]] int count(const PixelBox& box, Holds&& is_counted) const {
    const Point low = window_.to_window({box.left, box.bottom()});
    const Point high = window_.to_window({box.right(), box.top});
    int sum = 0;
    for (int y = std::max(0, static_cast<int>(low.y)); y < std::min<double>(high.y, height()); ++y) {
      for (int x = std::max(0, static_cast<int>(low.x)); x < std::min<double>(high.x, width()); ++x)
        sum += is_counted(x, y) ? 1 : 0;
    }
    return sum;
  }

  StageWindow& window_;
  vtkSmartPointer<vtkImageData> image_;
};

}  // namespace rayproof::viz
