#pragma once
/// \file
/// A window of VTK's that shows a player (viz/player/player.hpp) and hands it keys, handles, slider and
/// buttons.

#include <memory>
#include <optional>
#include <string>

#include "viz/picture/picture.hpp"
#include "viz/player/player.hpp"

class vtkRenderWindow;
class vtkRenderWindowInteractor;

namespace rayproof::viz {

/// Where the scene and the slider's track lie in the window, in the pixels of a slide.
inline constexpr PixelBox window_scene{24, 60, 596, 290};
inline constexpr PixelBox slider_track{250, 358, 640, 20};

/// The window is made with the object and gone with it. A UserDisplay (viz/vtk/offscreen_display.hpp)
/// or an OffscreenDisplay must be there before.
///
/// It shows the storyboard's slide, the scene in true space with VTK's trackball camera, handle widgets on
/// what of the case can be moved, a camera orientation widget, a slider widget for t, and button widgets for
/// the steps. As long as something moves, transparent surfaces are drawn plainly; they are drawn with care
/// once it rests.
class StageWindow {
 public:
  /// The player must outlive the window. With no size the window is 1600 by 900, or as large as the screen
  /// comfortably holds.
  explicit StageWindow(Player& player, int width = 0, int height = 0);
  ~StageWindow();
  StageWindow(const StageWindow&) = delete;
  StageWindow& operator=(const StageWindow&) = delete;

  /// Until the user quits or closes the window.
  void run();
  /// Hands out all events that have come, and shows what became of it.
  void handle_events();
  /// Shows the player as it is now, with care.
  void repaint();

  [[nodiscard]] vtkRenderWindow& window();
  [[nodiscard]] vtkRenderWindowInteractor& interactor();
  /// From the slide's pixels to the window's, whose y points up, as VTK's events have them.
  [[nodiscard]] Point to_window(const Point& p) const;
  /// Where a handle is seen, in the window's pixels; nothing where it is not shown.
  [[nodiscard]] std::optional<Point> seen(const std::string& handle) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// The slide's title, caption and numbers, what the arrow keys move or why a case was refused, t and what
/// changes with it. The faces of widgets are not in it.
[[nodiscard]] Picture window_sheet(const Player& player);

}  // namespace rayproof::viz
