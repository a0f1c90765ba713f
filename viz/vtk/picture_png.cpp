#include "viz/vtk/picture_png.hpp"

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <cmath>

#include "viz/vtk/raster_png.hpp"
#include "viz/vtk/sheet/picture_item.hpp"
#include "viz/vtk/space/space_scene.hpp"

namespace rayproof::viz {

class PictureCanvas::Impl {
 public:
  Impl() {
    actor_->GetScene()->AddItem(item_);
    actor_->GetScene()->SetRenderer(sheet_);
    sheet_->AddActor(actor_);
    backdrop_->SetBackground(1, 1, 1);
    window_->SetOffScreenRendering(1);
    prepare_for_space(*window_);
    window_->SetNumberOfLayers(3);
    sheet_->SetLayer(2);
    window_->AddRenderer(backdrop_);
    window_->AddRenderer(sheet_);
  }

  Raster draw(Picture picture, const std::vector<Inlay>& inlays, double scale, bool is_fine) {
    window_->SetSize(static_cast<int>(std::lround(picture.width * scale)),
                     static_cast<int>(std::lround(picture.height * scale)));
    has_spaces(inlays.size());
    for (std::size_t i = 0; i < inlays.size(); ++i) {
      const auto& [stage, step, frame_of_inlay] = inlays[i];
      const auto& frame = frame_of_inlay;  // clang++ 14 captures no structured binding
      spaces_[i]->SetViewport(frame.left / picture.width, 1 - frame.bottom() / picture.height,
                              frame.right() / picture.width, 1 - frame.top / picture.height);
      set_fine(*spaces_[i], is_fine);
      const SpaceScene scene(*spaces_[i], *stage, step);
      draw_labels(picture, frame, shown_in(*stage, step),
                  [&](const StageItem& item) { return scene.seen(item, frame); });
    }
    item_->picture = &picture;
    item_->scale = scale;
    return pixels_of(*window_);
  }

 private:
  void has_spaces(std::size_t count) {
    for (; spaces_.size() > count; spaces_.pop_back()) window_->RemoveRenderer(spaces_.back());
    while (spaces_.size() < count) {
      const auto& space = spaces_.emplace_back(vtkSmartPointer<vtkRenderer>::New());
      space->SetLayer(1);
      window_->AddRenderer(space);
    }
  }

  vtkNew<PictureItem> item_;
  vtkNew<vtkContextActor> actor_;
  vtkNew<vtkRenderer> backdrop_, sheet_;
  std::vector<vtkSmartPointer<vtkRenderer>> spaces_;
  vtkNew<vtkRenderWindow> window_;
};

PictureCanvas::PictureCanvas() : impl_(std::make_unique<Impl>()) {}
PictureCanvas::~PictureCanvas() = default;

Raster PictureCanvas::draw(const Picture& picture, const std::vector<Inlay>& scenes, double scale,
                           bool is_fine) {
  return impl_->draw(picture, scenes, scale, is_fine);
}

}  // namespace rayproof::viz
