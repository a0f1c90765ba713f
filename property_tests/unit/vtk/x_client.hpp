#pragma once
/// \file
/// Another program on the display, which types and clicks as a user would.

#include <string>

namespace rayproof::viz {

/// Acts on the one window of a program of ours that is open on DISPLAY.
class XClient {
 public:
  XClient();
  ~XClient();
  XClient(const XClient&) = delete;
  XClient& operator=(const XClient&) = delete;

  /// Waits for at most so long for a window to be there; whether one is.
  [[nodiscard]] bool find_window(int seconds = 20);
  /// By the key's X name, "Right".
  void press_key(const std::string& name);
  /// At a place in pixels from the window's top left corner.
  void press_button(int x, int y);
  void release_button(int x, int y);
  void move_pointer(int x, int y);
  /// As the window manager does.
  void close_window();

 private:
  void send_button(int type, int x, int y);
  struct Connection;
  Connection* connection_;
};

}  // namespace rayproof::viz
