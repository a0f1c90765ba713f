#include "viz/vtk/space/still_canvas.hpp"

#include <fmt/format.h>
#include <vtkBase64Utilities.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include "case/escape.hpp"
#include "viz/vtk/picture_item.hpp"
#include "viz/vtk/space/space_scene.hpp"

namespace rayproof::viz {
namespace {

constexpr int still_width = 640, still_height = 400;
/// Of the picture's own pixels.
constexpr PixelBox still_frame{0, 0, 640, 640 / view_aspect};

std::string jpeg_of(vtkRenderWindow& window) {
  window.Render();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(&window);
  image->SetInputBufferTypeToRGB();
  image->ReadFrontBufferOff();
  vtkNew<vtkJPEGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->SetQuality(60);
  writer->WriteToMemoryOn();
  writer->Write();
  const auto& bytes = *writer->GetResult();
  const auto size = static_cast<std::size_t>(bytes.GetNumberOfValues());
  std::string text(size / 3 * 4 + 8, '\0');
  text.resize(vtkBase64Utilities::Encode(writer->GetResult()->GetPointer(0), size,
                                         reinterpret_cast<unsigned char*>(text.data())));
  return text;
}

}  // namespace

class StillCanvas::Impl {
 public:
  Impl() {
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);  // as depth peeling wants it
    window->SetAlphaBitPlanes(1);
    window->SetDPI(72);
    window->SetSize(still_width, still_height);
    window->SetNumberOfLayers(2);
    window->AddRenderer(space);
    window->AddRenderer(sheet);
    space->SetBackground(1, 1, 1);
    sort_surfaces(*space, true);
    space->SetUseFXAA(true);
    sheet->SetLayer(1);
    actor->GetScene()->AddItem(item);
    actor->GetScene()->SetRenderer(sheet);
    sheet->AddActor(actor);
    item->scale = still_width / still_frame.width;
  }

  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> space;
  vtkNew<vtkRenderer> sheet;
  vtkNew<vtkContextActor> actor;
  vtkNew<PictureItem> item;
};

StillCanvas::StillCanvas() : impl_(std::make_unique<Impl>()) {}
StillCanvas::~StillCanvas() = default;

std::string StillCanvas::still(const Stage& stage, std::size_t step) {
  const SpaceScene scene(*impl_->space, stage, step);
  Picture labels;
  labels.width = still_frame.width;
  labels.height = still_frame.height;
  draw_labels(labels, still_frame, shown_in(stage, step),
              [&](const StageItem& item) { return scene.seen(item, still_frame); });
  impl_->item->picture = &labels;
  return fmt::format("<img width=\"{}\" height=\"{}\" alt=\"{}\" src=\"data:image/jpeg;base64,{}\">",
                     still_width, still_height, escaped(stage.steps[step].caption), jpeg_of(*impl_->window));
}

}  // namespace rayproof::viz
