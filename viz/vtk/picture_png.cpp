#include "viz/vtk/picture_png.hpp"

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>

#include <cmath>

#include "viz/vtk/picture_item.hpp"
#include "viz/vtk/raster_png.hpp"
#include "viz/vtk/write_png.hpp"

namespace rayproof::viz {
namespace {

/// Calls `use` with an off-screen window that shows the picture.
template <class Use>
void in_window(const Picture& picture, double scale, Use&& use) {
  vtkNew<PictureItem> item;
  item->picture = &picture;
  item->scale = scale;
  vtkNew<vtkContextActor> actor;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  actor->GetScene()->AddItem(item);
  actor->GetScene()->SetRenderer(renderer);
  renderer->SetBackground(1, 1, 1);
  renderer->AddActor(actor);
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(8);
  window->SetDPI(72);
  window->SetSize(static_cast<int>(std::lround(picture.width * scale)),
                  static_cast<int>(std::lround(picture.height * scale)));
  window->AddRenderer(renderer);
  use(*window);
}

}  // namespace

void write_picture(const Picture& picture, const std::string& path, double scale) {
  in_window(picture, scale, [&path](vtkRenderWindow& window) { write_png(window, path); });
}

Raster draw_picture(const Picture& picture) {
  Raster raster;
  in_window(picture, png_scale, [&raster](vtkRenderWindow& window) { raster = pixels_of(window); });
  return raster;
}

}  // namespace rayproof::viz
