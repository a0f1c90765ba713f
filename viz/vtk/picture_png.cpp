#include "viz/vtk/picture_png.hpp"

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>

#include <cmath>

#include "viz/vtk/picture_item.hpp"
#include "viz/vtk/write_png.hpp"

namespace rayproof::viz {

class PictureCanvas::Impl {
 public:
  Impl() {
    actor_->GetScene()->AddItem(item_);
    actor_->GetScene()->SetRenderer(renderer_);
    renderer_->SetBackground(1, 1, 1);
    renderer_->AddActor(actor_);
    window_->SetOffScreenRendering(1);
    window_->SetMultiSamples(8);
    window_->SetDPI(72);
    window_->AddRenderer(renderer_);
  }

  /// The window with the picture in it; it shows the picture when it is rendered.
  [[nodiscard]] vtkRenderWindow& window_of(const Picture& picture, double scale) {
    item_->picture = &picture;
    item_->scale = scale;
    window_->SetSize(static_cast<int>(std::lround(picture.width * scale)),
                     static_cast<int>(std::lround(picture.height * scale)));
    return *window_;
  }

 private:
  vtkNew<PictureItem> item_;
  vtkNew<vtkContextActor> actor_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkRenderWindow> window_;
};

PictureCanvas::PictureCanvas() : impl_(std::make_unique<Impl>()) {}
PictureCanvas::~PictureCanvas() = default;

void PictureCanvas::write(const Picture& picture, const std::string& path, double scale) {
  write_png(impl_->window_of(picture, scale), path);
}

Raster PictureCanvas::draw(const Picture& picture, double scale) {
  return pixels_of(impl_->window_of(picture, scale));
}

}  // namespace rayproof::viz
