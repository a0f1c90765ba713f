#include "viz/vtk/window/stage_window.hpp"

#include <fmt/format.h>
#include <vtkCamera.h>
#include <vtkCameraOrientationRepresentation.h>
#include <vtkCameraOrientationWidget.h>
#include <vtkRenderWindowInteractor.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "case/print_to_stderr.hpp"
#include "case/writer.hpp"
#include "viz/flat/stage_picture.hpp"
#include "viz/vtk/offscreen_display.hpp"
#include "viz/vtk/picture_png.hpp"
#include "viz/vtk/window/handle_widgets.hpp"
#include "viz/vtk/window/widgets.hpp"

namespace rayproof::viz {
namespace {

/// The window wakes up by events alone; this is for those that came while it drew.
constexpr int longest_sleep_ms = 250;
/// After this the scene is at rest, and is drawn with care.
constexpr int rest_ms = 80;
constexpr double arrow_degrees = 5;
constexpr double arrow_pixels = 8;  ///< of the slide

}  // namespace

/// Ends in the window's own order: the widgets first, the window last.
class StageWindow::Impl {
 public:
  Impl(Player& shown, int width, int height) : player(shown) {
    if (width <= 0 || height <= 0) {
      const int* const screen = view.window().GetScreenSize();
      width = static_cast<int>(std::lround(std::min({1600.0, 0.95 * screen[0], 0.85 * screen[1] * 16 / 9})));
      height = width * 9 / 16;
    }
    view.window().SetSize(width, height);
    interactor->SetRenderWindow(&view.window());
    interactor->SetInteractorStyle(style);
    interactor->EnableRenderOff();  // a drag makes more events than pictures can be drawn
    for (const unsigned long event : {vtkCommand::KeyPressEvent, vtkCommand::ExitEvent,
                                      vtkCommand::ConfigureEvent, vtkCommand::RenderEvent})
      interactor->AddObserver(event, this, &Impl::hear);
    interactor->Initialize();
    make_compass();
    repaint(true);
  }

  void hear(vtkObject* source, unsigned long event, void* /*nothing*/) {
    is_stale = true;
    if (event == vtkCommand::ExitEvent) is_over = true;
    if (event == vtkCommand::KeyPressEvent) {
      const char* const key = interactor->GetKeySym();
      const bool has_modifier = interactor->GetControlKey() != 0 || interactor->GetAltKey() != 0;
      if (key != nullptr && !has_modifier) press_key(key);
    }
    // The compass shows all there is, the floor too.
    if (source == compass && event == vtkCommand::EndInteractionEvent) fits_again = true;
  }

  void press_key(const std::string& key) {
    switch (player.press_key(key, interactor->GetShiftKey() != 0)) {
      case Request::none:
        break;
      case Request::quit:
        is_over = true;
        break;
      case Request::print_case:
        fmt::print("{}\n", write_case(player.stage().one));
        std::fflush(stdout);
        break;
      case Request::save_picture:
        save_picture();
        break;
      case Request::move_focused:
        move_focused(key);
        break;
      case Request::nearer:
        interactor->InvokeEvent(vtkCommand::MouseWheelForwardEvent);
        break;
      case Request::farther:
        interactor->InvokeEvent(vtkCommand::MouseWheelBackwardEvent);
        break;
      case Request::look_anew:
        is_turned = false;
        placed_at = view.space().GetActiveCamera()->GetMTime();
    }
    is_stale = true;
  }

  void move_focused(const std::string& key) {
    const double right = key == "Right" ? 1 : key == "Left" ? -1 : 0;
    const double up = key == "Up" ? 1 : key == "Down" ? -1 : 0;
    if (player.focus() == Focus::handle)
      return handles.nudge(right * arrow_pixels * view.scale(), up * arrow_pixels * view.scale());
    vtkCamera& camera = *view.space().GetActiveCamera();
    camera.Azimuth(-right * arrow_degrees);
    camera.Elevation(-up * arrow_degrees);
    camera.OrthogonalizeViewUp();
  }

  /// Not where a storyboard of the same walkthrough has its slides.
  void save_picture() {
    const std::string path = fmt::format("{}-{}-window.png", player.stage().name, player.step() + 1);
    try {
      repaint(true);
      write_png(pixels_of(view.window()), path);
      print_to_stderr("saved {}\n", path);
    } catch (const std::runtime_error& failure) {
      print_to_stderr("rayproof walk: {}\n", failure.what());
    }
  }

  void make_compass() {
    compass->SetParentRenderer(&view.space());
    compass->SetAnimate(false);
    compass->CreateDefaultRepresentation();
    compass->GetDefaultRenderer()->SetLayer(4);
    compass->AddObserver(vtkCommand::EndInteractionEvent, this, &Impl::hear);
  }

  void fit() {
    view.fit();
    slider.fit();
    const int* const size = view.window().GetSize();
    auto& axes = *vtkCameraOrientationRepresentation::SafeDownCast(compass->GetRepresentation());
    const Point corner = view.to_window({window_scene.right(), window_scene.top});
    axes.SetPadding(static_cast<int>(size[0] - corner.x), static_cast<int>(size[1] - corner.y));
    const int side = static_cast<int>(64 * view.scale());
    axes.SetSize(side, side);
    compass->SquareResize();
  }

  /// What stays of the camera: all of it while a handle is held, or where the user has turned it and the step
  /// wants the same view.
  [[nodiscard]] Look look(const StageView& wanted) {
    if (view.space().GetActiveCamera()->GetMTime() != placed_at) is_turned = true;
    if (last_name != player.stage().name) is_turned = false;
    const bool is_same =
        wanted.centre == last_view.centre && wanted.radius == last_view.radius && !fits_again;
    last_name = player.stage().name;
    last_view = wanted;
    fits_again = false;
    if (player.is_held() || (is_turned && is_same)) return Look::from_same_place;
    return is_turned && !style->is_flat ? Look::from_same_side : Look::anew;
  }

  void show_scene(const Picture& sheet) {
    const Stage shown = player.shown();
    const StageView& wanted = shown.steps[player.step()].view;
    const bool was_flat = style->is_flat;
    style->is_flat = shown.camera.is_flat || shown.steps[player.step()].is_apart;
    if (was_flat != style->is_flat) is_turned = false;
    (void)view.show(shown, player.step(), sheet, look(wanted));
    placed_at = view.space().GetActiveCamera()->GetMTime();
    handles.show(shown);
    compass->SetEnabled(style->is_flat ? 0 : 1);
    slider.show(shown, player.t());
  }

  void repaint(bool is_fine) {
    handles.follow();
    is_stale = false;
    is_drawn_fine = is_fine;
    fit();
    view.set_fine(is_fine);
    view.window().SetWindowName(("rayproof walk: " + player.stage().name).c_str());
    Picture sheet = window_sheet(player);
    const std::vector<Button> all = buttons_of(player);
    draw_buttons(sheet, all);
    buttons.show(all);
    if (player.is_help_shown()) {
      view.show(sheet);
      handles.hide();
      compass->Off();
      slider.hide();
    } else {
      show_scene(sheet);
    }
    view.window().Render();
  }

  Player& player;
  bool is_stale = false;
  bool is_drawn_fine = false;
  bool is_over = false;
  bool is_turned = false;
  bool fits_again = false;
  vtkMTimeType placed_at = 0;  ///< when the camera was last where we put it
  StageView last_view{};
  std::string last_name{};
  SlideView view{window_scene};
  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkNew<OrbitStyle> style;
  vtkNew<vtkCameraOrientationWidget> compass;
  HandleWidgets handles{view, player};
  TimeSlider slider{view, [this](double t) {
                      player.set_t(t);
                      is_stale = true;
                    }};
  Buttons buttons{view, [this](const std::string& key) { press_key(key); }};
};

StageWindow::StageWindow(Player& player, int width, int height)
    : impl_(std::make_unique<Impl>(player, width, height)) {}
StageWindow::~StageWindow() = default;

void StageWindow::handle_events() {
  dispatch_events(*impl_->interactor);
  // Once for all that have come: a drag makes more events than pictures can be drawn.
  if (impl_->is_stale && !impl_->is_over) impl_->repaint(false);
}

// VTK 9.1's own loops are left aside: once asked to end they never return, or read from a closed connection.
void StageWindow::run() {
  while (!impl_->is_over) {
    handle_events();
    if (impl_->is_over) break;
    const bool has_event =
        wait_for_events(*impl_->interactor, impl_->is_drawn_fine ? longest_sleep_ms : rest_ms);
    if (!has_event && !impl_->is_drawn_fine) impl_->repaint(true);
  }
}
void StageWindow::repaint() { impl_->repaint(true); }
vtkRenderWindow& StageWindow::window() { return impl_->view.window(); }
vtkRenderWindowInteractor& StageWindow::interactor() { return *impl_->interactor; }
Point StageWindow::to_window(const Point& p) const { return impl_->view.to_window(p); }
std::optional<Point> StageWindow::seen(const std::string& handle) const {
  return impl_->handles.seen(handle);
}

}  // namespace rayproof::viz
