#include "viz/vtk/still.hpp"

#include <fmt/format.h>
#include <vtkBase64Utilities.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include "case/escape.hpp"
#include "viz/vtk/image_of.hpp"

namespace rayproof::viz {
namespace {

constexpr PixelBox still_frame{0, 0, 640, 640 / view_aspect};

std::string jpeg_of(const Raster& picture) {
  vtkNew<vtkJPEGWriter> writer;
  writer->SetInputData(image_of(picture));
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

std::string still_of(PictureCanvas& canvas, const Stage& stage, std::size_t step) {
  Picture labels;
  labels.width = still_frame.width;
  labels.height = still_frame.height;
  const Raster picture = canvas.draw(labels, {{&stage, step, still_frame}}, 1);
  return fmt::format("<img width=\"{}\" height=\"{}\" alt=\"{}\" src=\"data:image/jpeg;base64,{}\">",
                     picture.width, picture.height, escaped(stage.steps[step].caption), jpeg_of(picture));
}

}  // namespace rayproof::viz
