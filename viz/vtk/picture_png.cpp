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
#include "viz/vtk/space/triad.hpp"

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
    has_views(inlays.size());
    for (std::size_t i = 0; i < inlays.size(); ++i) {
      const auto& [stage, step, frame_of_inlay] = inlays[i];
      const auto& frame = frame_of_inlay;  // clang++ 14 captures no structured binding
      const auto& [space, triad] = views_[i];
      put(*space, frame, picture);
      put(triad->renderer(), triad_place(frame), picture);
      set_fine(*space, is_fine);
      const SpaceScene scene(*space, *stage, step);
      triad->show(*space, !scene.is_flat());
      draw_labels(
          picture, frame, shown_in(*stage, step),
          [&](const StageItem& item) { return scene.seen(item, frame); },
          scene.is_flat() ? std::optional<PixelBox>() : triad_place(frame));
    }
    item_->picture = &picture;
    item_->scale = scale;
    return pixels_of(*window_);
  }

 private:
  static void put(vtkRenderer& renderer, const PixelBox& place, const Picture& picture) {
    renderer.SetViewport(place.left / picture.width, 1 - place.bottom() / picture.height,
                         place.right() / picture.width, 1 - place.top / picture.height);
  }

  void has_views(std::size_t count) {
    for (; views_.size() > count; views_.pop_back()) {
      window_->RemoveRenderer(views_.back().space);
      window_->RemoveRenderer(&views_.back().triad->renderer());
    }
    while (views_.size() < count) {
      View& view = views_.emplace_back();
      for (vtkRenderer* const renderer : {view.space.GetPointer(), &view.triad->renderer()}) {
        renderer->SetLayer(1);
        window_->AddRenderer(renderer);
      }
    }
  }

  struct View {
    vtkSmartPointer<vtkRenderer> space = vtkSmartPointer<vtkRenderer>::New();
    std::unique_ptr<Triad> triad = std::make_unique<Triad>();
  };
  vtkNew<PictureItem> item_;
  vtkNew<vtkContextActor> actor_;
  vtkNew<vtkRenderer> backdrop_, sheet_;
  std::vector<View> views_;
  vtkNew<vtkRenderWindow> window_;
};

PictureCanvas::PictureCanvas() : impl_(std::make_unique<Impl>()) {}
PictureCanvas::~PictureCanvas() = default;

Raster PictureCanvas::draw(const Picture& picture, const std::vector<Inlay>& scenes, double scale,
                           bool is_fine) {
  return impl_->draw(picture, scenes, scale, is_fine);
}

}  // namespace rayproof::viz
