#pragma once
/// \file
/// A window under test.

#include <gtest/gtest.h>
#include <vtkCommand.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <cmath>
#include <stdexcept>

#include "unit/viz/player/player.hpp"
#include "viz/flat/stage_picture.hpp"
#include "viz/vtk/offscreen_display.hpp"
#include "viz/vtk/window/stage_window.hpp"
#include "viz/vtk/window/widgets.hpp"

namespace rayproof::viz {

/// A window of a player, fed with the events that VTK makes of what a user does.
struct Shown {
  explicit Shown(Player shown, int width = 960, int height = 540)
      : player(std::move(shown)), window(player, width, height) {}

  void send(const Point& at, unsigned long event) {
    window.interactor().SetEventInformation(static_cast<int>(std::lround(at.x)),
                                            static_cast<int>(std::lround(at.y)));
    window.interactor().InvokeEvent(event);
  }
  void press_key(const char* key) {
    window.interactor().SetEventInformation(0, 0, 0, 0, 0, 1, key);
    window.interactor().InvokeEvent(vtkCommand::KeyPressEvent);
    window.handle_events();
  }
  void press(const Point& at) {
    send(at, vtkCommand::MouseMoveEvent);
    send(at, vtkCommand::LeftButtonPressEvent);
  }
  void drag(const Point& from, const Point& to) {
    press(from);
    send(to, vtkCommand::MouseMoveEvent);
    send(to, vtkCommand::LeftButtonReleaseEvent);
    window.handle_events();
  }
  [[nodiscard]] Point bar_at(double t) const {
    const StageSlider& slider = *player.stage().slider;
    const double part = (t - slider.from) / (slider.to - slider.from);
    return window.to_window({slider_track.left + part * slider_track.width, slider_track.centre().y});
  }
  [[nodiscard]] Point button(const std::string& key) const {
    for (const Button& one : buttons_of(player)) {
      if (one.key == key) return window.to_window(one.box.centre());
    }
    throw std::logic_error("no button for " + key);
  }

  Player player;
  StageWindow window;
};

class Window : public testing::Test {
 protected:
  OffscreenDisplay display{"1680x1050x24"};
  Shown shown{sphere_player()};
};

}  // namespace rayproof::viz
