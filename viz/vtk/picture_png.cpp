#include "viz/vtk/picture_png.hpp"

#include <vtkAxesActor.h>
#include <vtkCamera.h>
#include <vtkCaptionActor2D.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "viz/picture/picture.hpp"
#include "viz/scene/shown_items.hpp"
#include "viz/vtk/sheet/picture_item.hpp"
#include "viz/vtk/space/space_scene.hpp"

namespace rayproof::viz {
namespace {

/// The place of the axes in a scene's frame, where no label may stand: the first corner that nothing of the
/// scene crosses, or else the lower left one.
PixelBox triad_place(const PixelBox& frame, const std::vector<ShownItem>& shown, const Outline& outline) {
  const double size = 0.25 * frame.height, right = frame.right() - size, low = frame.bottom() - size;
  const std::array<PixelBox, 4> corners{{{frame.left, low, size, size},
                                         {right, low, size, size},
                                         {frame.left, frame.top, size, size},
                                         {right, frame.top, size, size}}};
  const auto is_free = [&](const PixelBox& corner) {
    return std::ranges::none_of(shown, [&](const ShownItem& one) {
      std::vector<Point> line = outline(*one.item);
      if (!line.empty()) line.push_back(line.front());
      return !clip_line(line, corner).empty();
    });
  };
  const auto found = std::ranges::find_if(corners, is_free);
  return found != corners.end() ? *found : corners[0];
}

void add_axes(vtkRenderer& triad) {
  vtkNew<vtkAxesActor> axes;
  axes->SetXAxisLabelText("x");
  axes->SetYAxisLabelText("y");
  axes->SetZAxisLabelText("z");
  axes->SetNormalizedLabelPosition(1.3, 1.3, 1.3);
  for (vtkCaptionActor2D* const caption :
       {axes->GetXAxisCaptionActor2D(), axes->GetYAxisCaptionActor2D(), axes->GetZAxisCaptionActor2D()}) {
    vtkTextProperty& text = *caption->GetCaptionTextProperty();
    text.ItalicOff();
    text.ShadowOff();
    text.SetColor(0.1, 0.1, 0.1);
    caption->SetWidth(0.3);
    caption->SetHeight(0.2);
  }
  triad.AddActor(axes);
  triad.SetInteractive(0);
}

/// Turns them as a scene's camera sees them.
void turn(vtkRenderer& triad, vtkCamera& seen_by) {
  vtkCamera& camera = *triad.GetActiveCamera();
  camera.SetParallelProjection(1);
  camera.SetParallelScale(1.55);
  camera.SetFocalPoint(0, 0, 0);
  camera.SetPosition(seen_by.GetViewPlaneNormal());
  camera.SetViewUp(seen_by.GetViewUp());
  camera.SetClippingRange(-3, 3);
}

}  // namespace

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
      set_fine(*space, is_fine);
      const SpaceScene scene(*space, *stage, step);
      triad->SetDraw(scene.is_flat() ? 0 : 1);
      turn(*triad, *space->GetActiveCamera());
      const std::vector<ShownItem> shown = shown_in(*stage, step);
      const Outline outline = [&](const StageItem& item) { return scene.seen(item, frame); };
      const PixelBox corner = triad_place(frame, shown, outline);
      put(*triad, corner, picture);
      draw_labels(picture, frame, shown, outline,
                  scene.is_flat() ? std::optional<PixelBox>() : std::optional<PixelBox>(corner));
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
    for (; views_.size() > count; views_.pop_back())
      for (const auto& renderer : views_.back()) window_->RemoveRenderer(renderer);
    while (views_.size() < count) {
      for (auto& renderer : views_.emplace_back()) {
        renderer = vtkSmartPointer<vtkRenderer>::New();
        renderer->SetLayer(1);
        window_->AddRenderer(renderer);
      }
      add_axes(*views_.back()[1]);
    }
  }

  vtkNew<PictureItem> item_;
  vtkNew<vtkContextActor> actor_;
  vtkNew<vtkRenderer> backdrop_, sheet_;
  std::vector<std::array<vtkSmartPointer<vtkRenderer>, 2>> views_;  ///< of each inlay the scene and its axes
  vtkNew<vtkRenderWindow> window_;
};

PictureCanvas::PictureCanvas() : impl_(std::make_unique<Impl>()) {}
PictureCanvas::~PictureCanvas() = default;

Raster PictureCanvas::draw(const Picture& picture, const std::vector<Inlay>& scenes, double scale,
                           bool is_fine) {
  return impl_->draw(picture, scenes, scale, is_fine);
}

}  // namespace rayproof::viz
