#pragma once
/// \file
/// The user's X display, as far as VTK leaves it to its caller. Apart, since X's header defines macros of
/// common names.

class vtkRenderWindowInteractor;

namespace rayproof::viz {

/// A connection to the user's DISPLAY, where that can show a window of VTK's: make one before the first
/// vtkRenderWindow and keep it until the last one is gone. (A server whose last client leaves may start anew
/// and for a moment take no other.)
class UserDisplay {
 public:
  /// Throws NoDisplay (viz/vtk/offscreen_display.hpp) with one sentence where there is no display, or none
  /// with OpenGL: VTK itself would abort the process.
  UserDisplay();
  ~UserDisplay();
  UserDisplay(const UserDisplay&) = delete;
  UserDisplay& operator=(const UserDisplay&) = delete;

 private:
  void* connection_ = nullptr;
};

/// Hands an initialized interactor of VTK's all events that have come for its window.
void dispatch_events(vtkRenderWindowInteractor& interactor);

/// Sleeps until an event has come for the interactor's window, or for so long; whether one has.
bool wait_for_events(vtkRenderWindowInteractor& interactor, int milliseconds);

}  // namespace rayproof::viz
