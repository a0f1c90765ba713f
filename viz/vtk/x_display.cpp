#include "viz/vtk/offscreen_display.hpp"

#include <poll.h>
#include <vtkRenderWindow.h>
#include <vtkXRenderWindowInteractor.h>

#include <cstdlib>
#include <string>

namespace rayproof::viz {
namespace {

Display* display_of(vtkRenderWindowInteractor& interactor) {
  return static_cast<Display*>(interactor.GetRenderWindow()->GetGenericDisplayId());
}

}  // namespace

UserDisplay::UserDisplay() {
  const char* const name = std::getenv("DISPLAY");
  if (name == nullptr || *name == '\0') {
    throw NoDisplay("a window needs a display, and DISPLAY is not set; without --window none is needed");
  }
  Display* const display = XOpenDisplay(nullptr);
  if (display == nullptr) {
    throw NoDisplay(std::string("the display ") + name +
                    " of DISPLAY can't be opened; without --window none is needed");
  }
  int ignored = 0;
  if (XQueryExtension(display, "GLX", &ignored, &ignored, &ignored) == 0) {
    XCloseDisplay(display);
    throw NoDisplay(std::string("the display ") + name +
                    " can't show OpenGL (it lacks GLX); without --window none is needed");
  }
  connection_ = display;
}

UserDisplay::~UserDisplay() { XCloseDisplay(static_cast<Display*>(connection_)); }

void dispatch_events(vtkRenderWindowInteractor& interactor) {
  Display* const display = display_of(interactor);
  auto* const x = vtkXRenderWindowInteractor::SafeDownCast(&interactor);
  while (XPending(display) > 0) {
    XEvent event;
    XNextEvent(display, &event);
    x->DispatchEvent(&event);
  }
}

bool wait_for_events(vtkRenderWindowInteractor& interactor, int milliseconds) {
  Display* const display = display_of(interactor);
  if (XPending(display) > 0) return true;
  pollfd connection{ConnectionNumber(display), POLLIN, 0};
  return poll(&connection, 1, milliseconds) > 0;
}

}  // namespace rayproof::viz
