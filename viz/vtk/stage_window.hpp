#pragma once
/// \file
/// A window that shows a player (viz/player/player.hpp) and hands it keys and mouse.

#include <memory>
#include <string>

#include "viz/player/player.hpp"

class vtkRenderWindow;
class vtkRenderWindowInteractor;

namespace rayproof::viz {

/// The window is made with the object and gone with it. A UserDisplay (viz/vtk/x_display.hpp)
/// or an OffscreenDisplay must be there before.
/// The player's picture is as large as the window allows, in its middle, its proportions kept.
class StageWindow {
 public:
  /// The player must outlive the window. With no size the window is as large as the screen comfortably holds.
  explicit StageWindow(Player& player, int width = 0, int height = 0);
  ~StageWindow();
  StageWindow(const StageWindow&) = delete;
  StageWindow& operator=(const StageWindow&) = delete;

  /// Until the user quits or closes the window.
  void run();
  /// Hands the player all events that have come, and shows what became of it.
  void handle_events();
  /// Shows the player as it is now.
  void repaint();

  [[nodiscard]] vtkRenderWindow& window();
  [[nodiscard]] vtkRenderWindowInteractor& interactor();
  /// From the picture's pixels to the window's, whose y points up, as VTK's events have them.
  [[nodiscard]] Point to_window(const Point& p) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rayproof::viz
