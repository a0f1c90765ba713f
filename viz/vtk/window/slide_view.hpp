#pragma once
/// \file
/// A slide in a window of VTK's: the step in true space, and over it a sheet with title, numbers and caption.

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <array>

#include "viz/flat/stage_picture.hpp"
#include "viz/vtk/sheet/picture_item.hpp"
#include "viz/vtk/space/space_scene.hpp"

namespace rayproof::viz {

/// The slide is as large as the window allows, in its middle, its proportions kept.
class SlideView {
 public:
  /// `scene` is the scene's frame in a slide of slide_width by slide_height.
  explicit SlideView(const PixelBox& scene) : scene_(scene) {
    prepare_for_space(*window_);
    window_->SetNumberOfLayers(4);
    int layer = 0;
    for (vtkRenderer* const renderer :
         {backdrop_.GetPointer(), space_.GetPointer(), front_.GetPointer(), sheet_.GetPointer()}) {
      renderer->SetLayer(layer++);
      renderer->SetInteractive(renderer == space_ ? 1 : 0);
      window_->AddRenderer(renderer);
    }
    backdrop_->SetBackground(1, 1, 1);
    front_->SetActiveCamera(space_->GetActiveCamera());
    set_fine(true);
    for (std::size_t i = 0; i < items_.size(); ++i) {
      vtkNew<vtkContextActor> actor;
      actor->GetScene()->AddItem(items_[i]);
      actor->GetScene()->SetRenderer(sheet_);
      sheet_->AddActor(actor);
      items_[i]->picture = &picture_;
      items_[i]->part = i;
      items_[i]->parts = items_.size();
    }
  }
  SlideView(const SlideView&) = delete;
  SlideView& operator=(const SlideView&) = delete;

  /// Puts the layers where the window's size has them.
  void fit() {
    const int* const size = window_->GetSize();
    const double scale = std::min(size[0] / slide_width, size[1] / slide_height);
    for (const auto& item : items_) {
      item->scale = scale;
      item->left = (size[0] - scale * slide_width) / 2;
      item->bottom = (size[1] - scale * slide_height) / 2;
    }
    const Point low = to_window({scene_.left, scene_.bottom()});
    const Point high = to_window({scene_.right(), scene_.top});
    for (vtkRenderer* const renderer : {space_.GetPointer(), front_.GetPointer()})
      renderer->SetViewport(low.x / size[0], low.y / size[1], high.x / size[0], high.y / size[1]);
  }
  /// Fills the layers: the step, and the sheet with the step's labels put into it. Nothing is rendered yet.
  SpaceScene show(const Stage& stage, std::size_t step, const Picture& sheet, Look look) {
    const SpaceScene scene(*space_, stage, step, look, is_fine_ ? fine_sides : coarse_sides);
    picture_ = sheet;
    draw_labels(picture_, scene_, shown_in(stage, step),
                [&](const StageItem& item) { return scene.seen(item, scene_); });
    if (!is_fine_) {
      for (Element& element : picture_.elements)
        if (auto* const text = std::get_if<Text>(&element)) text->halo = false;
    }
    return scene;
  }
  /// Fills the sheet alone; the space is empty.
  void show(const Picture& sheet) {
    space_->RemoveAllViewProps();
    picture_ = sheet;
  }
  /// Whether surfaces behind one another are sorted pixel by pixel, edges smoothed, round things made of
  /// many sides, lit pixel by pixel, each a body of its own, and labels have halos: twice the work. From the
  /// next `show` on.
  void set_fine(bool is_fine) {
    is_fine_ = is_fine;
    viz::set_fine(*space_, is_fine);
  }

  [[nodiscard]] vtkRenderWindow& window() { return *window_; }
  [[nodiscard]] vtkRenderer& space() { return *space_; }
  /// Before the space, with its camera: for what can be taken hold of.
  [[nodiscard]] vtkRenderer& front() { return *front_; }
  [[nodiscard]] vtkRenderer& sheet() { return *sheet_; }
  /// Pixels of the window for each of the slide's.
  [[nodiscard]] double scale() const { return items_[0]->scale; }
  /// From the slide's pixels to the window's, whose y points up, as VTK's events have them.
  [[nodiscard]] Point to_window(const Point& p) const {
    return {items_[0]->left + p.x * scale(), items_[0]->bottom + (slide_height - p.y) * scale()};
  }

 private:
  PixelBox scene_;
  Picture picture_{};
  bool is_fine_ = true;
  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkRenderer> backdrop_, space_, front_, sheet_;
  /// Each paints a part of the picture: VTK keeps 50 texts for each, and the next frame needs them again.
  std::array<vtkNew<PictureItem>, 4> items_;
};

}  // namespace rayproof::viz
