#pragma once
/// \file
/// A display for VTK to draw on where nobody looks.

#include <sys/types.h>

#include <optional>
#include <stdexcept>
#include <string>

class vtkRenderWindowInteractor;

namespace rayproof::viz {

/// No display could be started; the text says in one sentence what is missing.
class NoDisplay : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Runs a virtual X server of its own (Xvfb) while it lives, and makes it this process's DISPLAY; afterwards
/// DISPLAY is again what it was.
///
/// Debian's VTK draws through X11 alone and *aborts* without a display, even off-screen: make one of these
/// before the first vtkRenderWindow, keep it until the last one is gone. The server takes a free display
/// number by itself and ends with the object, with the thread that made it, and with the process, however
/// that ends (Ctrl-C included).
///
///     viz::OffscreenDisplay display;
///     vtkNew<vtkContextView> view;
///     … view->GetScene()->AddItem(chart); view->GetRenderWindow()->SetSize(1200, 800);
///     viz::write_png(viz::pixels_of(*view->GetRenderWindow()), "chart.png");
class OffscreenDisplay {
 public:
  /// Throws NoDisplay where Xvfb is missing, or three of them do not answer within ten seconds each.
  /// `screen` is its width, height and depth: of what is drawn off-screen the size does not depend on it.
  explicit OffscreenDisplay(const char* screen = "320x240x24");
  ~OffscreenDisplay();
  OffscreenDisplay(const OffscreenDisplay&) = delete;
  OffscreenDisplay& operator=(const OffscreenDisplay&) = delete;

 private:
  pid_t server_ = -1;
  std::optional<std::string> display_before_{};
};

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
