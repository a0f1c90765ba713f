#include "viz/vtk/window/widgets.hpp"

#include <vtkContextActor.h>
#include <vtkContextScene.h>

#include <algorithm>

#include "viz/flat/stage_picture.hpp"
#include "viz/vtk/sheet/picture_item.hpp"

namespace rayproof::viz {

SlideView::SlideView(const PixelBox& scene) : scene_(scene) {
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
SlideView::~SlideView() = default;

void SlideView::set_fine(bool is_fine) {
  is_fine_ = is_fine;
  viz::set_fine(*space_, is_fine);
}

double SlideView::scale() const { return items_[0]->scale; }

Point SlideView::to_window(const Point& p) const {
  return {items_[0]->left + p.x * scale(), items_[0]->bottom + (slide_height - p.y) * scale()};
}

void SlideView::fit() {
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

SpaceScene SlideView::show(const Stage& stage, std::size_t step, const Picture& sheet, Look look) {
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

void SlideView::show(const Picture& sheet) {
  space_->RemoveAllViewProps();
  picture_ = sheet;
}

}  // namespace rayproof::viz
