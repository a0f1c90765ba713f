#include "viz/vtk/stage_window.hpp"

#include <fmt/format.h>
#include <vtkCallbackCommand.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "case/writer.hpp"
#include "viz/vtk/picture_item.hpp"
#include "viz/vtk/picture_png.hpp"
#include "viz/vtk/x_display.hpp"

namespace rayproof::viz {
namespace {

/// The window wakes up by events alone; this is for those that came while it drew.
constexpr int longest_sleep_ms = 250;

constexpr unsigned long heard[] = {vtkCommand::KeyPressEvent,           vtkCommand::LeftButtonPressEvent,
                                   vtkCommand::MouseMoveEvent,          vtkCommand::LeftButtonReleaseEvent,
                                   vtkCommand::MouseWheelForwardEvent,  vtkCommand::ExitEvent,
                                   vtkCommand::MouseWheelBackwardEvent, vtkCommand::ConfigureEvent};

}  // namespace

/// Ends in the window's own order: the interactor first, the window last.
class StageWindow::Impl {
 public:
  Impl(Player& shown, int width, int height) : player(shown) {
    actor->GetScene()->AddItem(item);
    actor->GetScene()->SetRenderer(renderer);
    renderer->SetBackground(1, 1, 1);
    renderer->AddActor(actor);
    window->SetMultiSamples(8);
    window->SetDPI(72);
    window->AddRenderer(renderer);
    if (width <= 0 || height <= 0) {
      const int* screen = window->GetScreenSize();
      const double scale = std::min({1.5, 0.9 * screen[0] / player_width, 0.85 * screen[1] / player_height});
      width = static_cast<int>(std::lround(scale * player_width));
      height = static_cast<int>(std::lround(scale * player_height));
    }
    window->SetSize(width, height);
    interactor->SetRenderWindow(window);
    interactor->SetInteractorStyle(nullptr);
    item->picture = &picture;
    callback->SetClientData(this);
    callback->SetCallback(
        [](vtkObject*, unsigned long event, void* self, void*) { static_cast<Impl*>(self)->hear(event); });
    for (const unsigned long event : heard) interactor->AddObserver(event, callback);
  }

  void open() {
    fit();
    interactor->Initialize();
    repaint();
  }

  void repaint() {
    is_stale = false;
    picture = player.picture();
    window->SetWindowName(("rayproof walk: " + player.stage().name).c_str());
    fit();
    window->Render();
  }

  /// Scale and place of the picture in the window.
  void fit() {
    const int* size = window->GetSize();
    item->scale = std::min(size[0] / player_width, size[1] / player_height);
    item->left = (size[0] - item->scale * player_width) / 2;
    item->bottom = (size[1] - item->scale * player_height) / 2;
  }

  [[nodiscard]] Point pointer() const {
    const int* at = interactor->GetEventPosition();
    return {(at[0] - item->left) / item->scale, player_height - (at[1] - item->bottom) / item->scale};
  }

  void hear(unsigned long event) {
    Request request = Request::none;
    switch (event) {
      case vtkCommand::ExitEvent:
        is_over = true;
        return;
      case vtkCommand::ConfigureEvent:
        fit();
        break;
      case vtkCommand::KeyPressEvent:
        request = press_key();
        break;
      case vtkCommand::LeftButtonPressEvent:
        request = player.press(pointer());
        is_down = true;
        break;
      case vtkCommand::MouseMoveEvent:
        if (!is_down) return;
        player.drag_to(pointer());
        break;
      case vtkCommand::LeftButtonReleaseEvent:
        player.release();
        is_down = false;
        break;
      default:
        player.turn_wheel(event == vtkCommand::MouseWheelForwardEvent ? 1 : -1);
    }
    is_stale = true;
    if (request == Request::quit) is_over = true;
    if (request == Request::print_case) {
      fmt::print("{}\n", write_case(player.stage().one));
      std::fflush(stdout);
    }
    if (request == Request::save_picture) save_picture();
  }

  /// Not where a storyboard of the same walkthrough has its slides.
  void save_picture() {
    const std::string path = fmt::format("{}-{}-window.png", player.stage().name, player.step() + 1);
    try {
      PictureCanvas().write(player.picture(), path);
      fmt::print(stderr, "saved {}\n", path);
    } catch (const std::runtime_error& failure) {
      fmt::print(stderr, "rayproof walk: {}\n", failure.what());
    }
  }

  Request press_key() {
    const char* key = interactor->GetKeySym();
    const bool has_modifier = interactor->GetControlKey() != 0 || interactor->GetAltKey() != 0;
    if (key == nullptr || has_modifier) return Request::none;
    return player.press_key(key, interactor->GetShiftKey() != 0);
  }

  Player& player;
  Picture picture{};
  bool is_down = false;
  bool is_stale = false;
  bool is_over = false;
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkContextActor> actor;
  vtkNew<PictureItem> item;
  vtkNew<vtkCallbackCommand> callback;
  vtkNew<vtkRenderWindowInteractor> interactor;
};

StageWindow::StageWindow(Player& player, int width, int height)
    : impl_(std::make_unique<Impl>(player, width, height)) {
  impl_->open();
}
StageWindow::~StageWindow() = default;

void StageWindow::handle_events() {
  dispatch_events(*impl_->interactor);
  // Once for all that have come: a drag makes more events than pictures can be drawn.
  if (impl_->is_stale && !impl_->is_over) impl_->repaint();
}

// VTK 9.1's own loops are left aside: once asked to end they never return, or read from a closed connection.
void StageWindow::run() {
  while (!impl_->is_over) {
    handle_events();
    if (!impl_->is_over) wait_for_events(*impl_->interactor, longest_sleep_ms);
  }
}
void StageWindow::repaint() { impl_->repaint(); }
vtkRenderWindow& StageWindow::window() { return *impl_->window; }
vtkRenderWindowInteractor& StageWindow::interactor() { return *impl_->interactor; }

Point StageWindow::to_window(const Point& p) const {
  const PictureItem& item = *impl_->item;
  return {item.left + p.x * item.scale, item.bottom + (player_height - p.y) * item.scale};
}

}  // namespace rayproof::viz
