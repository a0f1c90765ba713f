#include <X11/Xlib.h>

#include <cstdlib>

#include "viz/vtk/offscreen_display.hpp"
#include "viz/vtk/stage_window.hpp"

namespace rayproof::viz {

void require_display() {
  const char* const name = std::getenv("DISPLAY");
  if (name == nullptr || *name == '\0') {
    throw NoDisplay("a window needs a display, and DISPLAY is not set; --html or --png need none");
  }
  Display* const display = XOpenDisplay(nullptr);
  if (display == nullptr) {
    throw NoDisplay(std::string("the display ") + name +
                    " of DISPLAY can't be opened; --html or --png need none");
  }
  int ignored = 0;
  const bool draws_opengl = XQueryExtension(display, "GLX", &ignored, &ignored, &ignored) != 0;
  XCloseDisplay(display);
  if (!draws_opengl) {
    throw NoDisplay(std::string("the display ") + name +
                    " can't show OpenGL (it lacks GLX); --html or --png work");
  }
}

}  // namespace rayproof::viz
