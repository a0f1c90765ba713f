#include "unit/vtk/x_client.hpp"

#include <unistd.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>

namespace rayproof::viz {

struct XClient::Connection {
  Display* display = nullptr;
  Window window = 0;
};

namespace {

/// A window may be gone between its being listed and its being asked for its name, which then fails with 0.
/// Xlib would end the process.
class WindowsMayVanish {
 public:
  WindowsMayVanish() : before_(XSetErrorHandler(ignored)) {}
  ~WindowsMayVanish() { XSetErrorHandler(before_); }
  WindowsMayVanish(const WindowsMayVanish&) = delete;
  WindowsMayVanish& operator=(const WindowsMayVanish&) = delete;

 private:
  static int ignored(Display* /*display*/, XErrorEvent* /*error*/) { return 0; }
  XErrorHandler before_;
};

}  // namespace

XClient::XClient() : connection_(new Connection{XOpenDisplay(nullptr), 0}) {}
XClient::~XClient() {
  if (connection_->display != nullptr) XCloseDisplay(connection_->display);
  delete connection_;
}

bool XClient::find_window(int seconds) {
  Display* const display = connection_->display;
  if (display == nullptr) return false;
  const WindowsMayVanish guard;
  for (int tries = 0; tries < 20 * seconds; ++tries, usleep(50'000)) {
    Window root = 0;
    Window parent = 0;
    Window* children = nullptr;
    unsigned count = 0;
    XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &count);
    for (unsigned i = 0; i < count; ++i) {
      char* name = nullptr;
      if (XFetchName(display, children[i], &name) == 0) continue;
      // What is sent before the window listens is lost.
      XWindowAttributes window{};
      const bool listens = XGetWindowAttributes(display, children[i], &window) != 0 &&
                           (window.all_event_masks & ButtonPressMask) != 0;
      if (listens && std::string(name).starts_with("rayproof ")) connection_->window = children[i];
      XFree(name);
    }
    if (children != nullptr) XFree(children);
    if (connection_->window != 0) return true;
  }
  return false;
}

void XClient::press_key(const std::string& name) {
  Display* const display = connection_->display;
  XEvent event{};
  event.xkey.type = KeyPress;
  event.xkey.window = connection_->window;
  event.xkey.keycode = XKeysymToKeycode(display, XStringToKeysym(name.c_str()));
  XSendEvent(display, connection_->window, True, KeyPressMask, &event);
  XSync(display, False);
}

void XClient::send_button(int type, int x, int y) {
  XEvent event{};
  event.xbutton.type = type;
  event.xbutton.window = connection_->window;
  event.xbutton.button = Button1;
  event.xbutton.x = x;
  event.xbutton.y = y;
  XSendEvent(connection_->display, connection_->window, True,
             type == ButtonPress ? ButtonPressMask : ButtonReleaseMask, &event);
  XSync(connection_->display, False);
}
void XClient::press_button(int x, int y) { send_button(ButtonPress, x, y); }
void XClient::release_button(int x, int y) { send_button(ButtonRelease, x, y); }

void XClient::move_pointer(int x, int y) {
  XWarpPointer(connection_->display, 0, connection_->window, 0, 0, 0, 0, x, y);
  XSync(connection_->display, False);
}

void XClient::close_window() {
  Display* const display = connection_->display;
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = connection_->window;
  event.xclient.message_type = XInternAtom(display, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = static_cast<long>(XInternAtom(display, "WM_DELETE_WINDOW", False));
  XSendEvent(display, connection_->window, False, NoEventMask, &event);
  XSync(display, False);
}

}  // namespace rayproof::viz
