#pragma once
/// \file
/// An error figure in a window of VTK's, whose pixels can be clicked.

#include <functional>
#include <memory>
#include <string>

#include "viz/vtk/render/error_figure.hpp"

class vtkRenderWindow;
class vtkRenderWindowInteractor;

namespace rayproof::render {

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

}  // namespace rayproof::render
