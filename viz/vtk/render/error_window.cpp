#include "viz/vtk/render/error_figure.hpp"

#include <vtkCamera.h>
#include <vtkImageActor.h>
#include <vtkImageData.h>
#include <vtkInteractorObserver.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "viz/vtk/offscreen_display.hpp"
#include "viz/vtk/picture_png.hpp"
#include "viz/vtk/window/widgets.hpp"

namespace rayproof::render {
namespace {

/// The window wakes up by events alone; this is for those that came while it drew.
constexpr int longest_sleep_ms = 250;
/// A pointer that moves farther between press and release drags.
constexpr int steady_pixels = 3;

}  // namespace

/// Ends in the window's own order: the image first, the window last.
class ErrorWindow::Impl {
 public:
  Impl(const viz::Raster& figure, ErrorLayout shown, Open asked)
      : layout(std::move(shown)), open(std::move(asked)), height(figure.height) {
    const int* const screen = window->GetScreenSize();
    const double scale = std::min({1.0, 0.95 * screen[0] / figure.width, 0.85 * screen[1] / figure.height});
    window->SetSize(static_cast<int>(scale * figure.width), static_cast<int>(scale * figure.height));
    image->SetInputData(viz::image_of(figure));
    image->InterpolateOff();
    renderer->AddActor(image);
    window->AddRenderer(renderer);
    // One of the figure's pixels is one length of the world.
    vtkCamera& camera = *renderer->GetActiveCamera();
    camera.ParallelProjectionOn();
    camera.SetFocalPoint((figure.width - 1) / 2.0, (figure.height - 1) / 2.0, 0);
    camera.SetPosition((figure.width - 1) / 2.0, (figure.height - 1) / 2.0, 1);
    camera.SetParallelScale(figure.height / 2.0);
    style->is_flat = true;
    interactor->SetRenderWindow(window);
    interactor->SetInteractorStyle(style);
    for (const unsigned long event :
         {vtkCommand::LeftButtonPressEvent, vtkCommand::KeyPressEvent, vtkCommand::ExitEvent})
      interactor->AddObserver(event, this, &Impl::hear);
    // From the press on the style keeps the pointer's events for itself.
    style->AddObserver(vtkCommand::EndInteractionEvent, this, &Impl::hear);
    interactor->Initialize();
    window->Render();
    window->SetWindowName("rayproof render: click a pixel for its case");  // which now listens
  }

  void hear(vtkObject* /*source*/, unsigned long event, void* /*nothing*/) {
    const int* const at = interactor->GetEventPosition();
    if (event == vtkCommand::ExitEvent) is_over = true;
    if (event == vtkCommand::KeyPressEvent) {
      const char* const key = interactor->GetKeySym();
      is_over = is_over || (key != nullptr && (std::string(key) == "q" || std::string(key) == "Escape"));
    }
    if (event == vtkCommand::LeftButtonPressEvent) pressed = {at[0], at[1]};
    if (event != vtkCommand::EndInteractionEvent || !pressed) return;
    const bool is_click =
        std::abs(at[0] - (*pressed)[0]) <= steady_pixels && std::abs(at[1] - (*pressed)[1]) <= steady_pixels;
    pressed.reset();
    if (is_click) click(at[0], at[1]);
  }

  void click(int x, int y) {
    double place[4];
    vtkInteractorObserver::ComputeDisplayToWorld(renderer, x, y, 0, place);
    const auto pixel = layout.pixel_at(std::floor(place[0] + 0.5), height - 1 - std::floor(place[1] + 0.5));
    if (pixel) window->SetWindowName(open(*pixel).c_str());
  }

  ErrorLayout layout;
  Open open;
  int height;
  bool is_over = false;
  std::optional<std::array<int, 2>> pressed{};  ///< where the button went down
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkNew<viz::OrbitStyle> style;
  vtkNew<vtkImageActor> image;
};

ErrorWindow::ErrorWindow(const viz::Raster& figure, const ErrorLayout& layout, Open open)
    : impl_(std::make_unique<Impl>(figure, layout, std::move(open))) {}
ErrorWindow::~ErrorWindow() = default;

void ErrorWindow::handle_events() { viz::dispatch_events(*impl_->interactor); }

// VTK 9.1's own loops are left aside, as in viz/vtk/window/stage_window.cpp.
void ErrorWindow::run() {
  while (!impl_->is_over) {
    handle_events();
    if (!impl_->is_over) (void)viz::wait_for_events(*impl_->interactor, longest_sleep_ms);
  }
}

vtkRenderWindow& ErrorWindow::window() { return *impl_->window; }
vtkRenderWindowInteractor& ErrorWindow::interactor() { return *impl_->interactor; }

viz::Point ErrorWindow::to_window(const viz::Point& pixel) const {
  double seen[3];
  vtkInteractorObserver::ComputeWorldToDisplay(impl_->renderer, pixel.x, impl_->height - 1 - pixel.y, 0,
                                               seen);
  return {seen[0], seen[1]};
}

}  // namespace rayproof::render
