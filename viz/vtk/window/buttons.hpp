#pragma once
/// \file
/// The window's row of buttons: VTK's button widgets over faces that the sheet shows.

#include <vtkButtonWidget.h>
#include <vtkSmartPointer.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "viz/player/player.hpp"
#include "viz/vtk/slide_view.hpp"

namespace rayproof::viz {

/// A button stands for a key, so that whatever can be clicked can be typed.
struct Button {
  PixelBox box{};
  std::string text;
  std::string key;
  bool is_current = false;
  bool is_enabled = true;
};

/// Back, each step, forth, and at the right the other walkthroughs, reset, help and quit.
[[nodiscard]] std::vector<Button> buttons_of(const Player& player);

/// The buttons' faces.
void draw_buttons(Picture& sheet, const std::vector<Button>& buttons);

class Buttons {
 public:
  using Press = std::function<void(const std::string& key)>;
  /// The view must outlive it and have an interactor.
  Buttons(SlideView& view, Press press) : view_(view), press_(std::move(press)) {}

  /// Lets just these be clicked.
  void show(const std::vector<Button>& buttons);

 private:
  void make_one();
  void hear(vtkObject* source, unsigned long event, void* data);

  SlideView& view_;
  Press press_;
  std::vector<vtkSmartPointer<vtkButtonWidget>> widgets_{};
  std::vector<std::array<double, 6>> placed_{};  ///< where each lies in the window
  std::vector<Button> shown_{};
};

}  // namespace rayproof::viz
