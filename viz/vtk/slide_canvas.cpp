#include "viz/vtk/slide_canvas.hpp"

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>

#include "viz/flat/stage_picture.hpp"
#include "viz/picture/palette.hpp"
#include "viz/scene/shown_items.hpp"
#include "viz/vtk/picture_item.hpp"
#include "viz/vtk/space/space_scene.hpp"
#include "viz/vtk/write_png.hpp"

namespace rayproof::viz {
namespace {

/// Pixels of a slide for each of its picture's.
constexpr double scale = 5.0 / 3;

/// The mean of the pixels at (x, y) and to its right and below.
Rgb mean_of_four(const Raster& raster, int x, int y) {
  Rgb mean;
  for (std::size_t i = 0; i < mean.size(); ++i) {
    const int sum =
        raster.at(x, y)[i] + raster.at(x + 1, y)[i] + raster.at(x, y + 1)[i] + raster.at(x + 1, y + 1)[i];
    mean[i] = static_cast<std::uint8_t>((sum + 2) / 4);
  }
  return mean;
}

}  // namespace

class SlideCanvas::Impl {
 public:
  Impl() {
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);  // as depth peeling wants it
    window->SetAlphaBitPlanes(1);
    window->SetDPI(72);
    window->SetSize(1600, 900);
    window->SetNumberOfLayers(3);
    window->AddRenderer(backdrop);
    window->AddRenderer(space);
    window->AddRenderer(sheet);
    backdrop->SetBackground(1, 1, 1);
    space->SetLayer(1);
    space->SetUseDepthPeeling(1);
    space->SetMaximumNumberOfPeels(6);
    space->SetOcclusionRatio(0.02);
    space->SetUseFXAA(true);
    space->SetViewport(slide_scene.left / slide_width, 1 - slide_scene.bottom() / slide_height,
                       slide_scene.right() / slide_width, 1 - slide_scene.top / slide_height);
    sheet->SetLayer(2);
    actor->GetScene()->AddItem(item);
    actor->GetScene()->SetRenderer(sheet);
    sheet->AddActor(actor);
    item->scale = scale;
  }

  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> backdrop;
  vtkNew<vtkRenderer> space;
  vtkNew<vtkRenderer> sheet;
  vtkNew<vtkContextActor> actor;
  vtkNew<PictureItem> item;
};

SlideCanvas::SlideCanvas() : impl_(std::make_unique<Impl>()) {}
SlideCanvas::~SlideCanvas() = default;

Raster SlideCanvas::draw(const Stage& stage, std::size_t step) {
  const SpaceScene scene(*impl_->space, stage, step);
  Picture picture = slide_frame(stage, step);
  draw_labels(picture, slide_scene, shown_in(stage, step),
              [&](const StageItem& item) { return scene.seen(item, slide_scene); });
  impl_->item->picture = &picture;
  return pixels_of(*impl_->window);
}

Raster contact_sheet(const std::vector<Raster>& slides) {
  constexpr int gap = 12;
  const int columns = slides.size() > 4 ? 3 : 2;
  const int rows = (static_cast<int>(slides.size()) + columns - 1) / columns;
  const int width = slides.front().width / 2;
  const int height = slides.front().height / 2;
  Raster sheet(gap + columns * (width + gap), gap + rows * (height + gap),
               rgb_of(colour_of(Role::frame).light));
  for (std::size_t i = 0; i < slides.size(); ++i) {
    const int left = gap + static_cast<int>(i) % columns * (width + gap);
    const int top = gap + static_cast<int>(i) / columns * (height + gap);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) sheet.at(left + x, top + y) = mean_of_four(slides[i], 2 * x, 2 * y);
    }
  }
  return sheet;
}

}  // namespace rayproof::viz
