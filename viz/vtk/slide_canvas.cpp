#include "viz/vtk/picture_png.hpp"

#include <fmt/format.h>
#include <vtkBase64Utilities.h>
#include <vtkImageData.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkOggTheoraWriter.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <stdexcept>

#include "case/escape.hpp"
#include "case/files.hpp"
#include "viz/flat/stage_picture.hpp"
#include "viz/picture/picture.hpp"

namespace rayproof::viz {
namespace {

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

vtkSmartPointer<vtkImageData> image_of(const Raster& raster) {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(raster.width, raster.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < raster.height; ++y) {
    auto* row = static_cast<unsigned char*>(image->GetScalarPointer(0, raster.height - 1 - y, 0));
    for (int x = 0; x < raster.width; ++x) row = std::copy_n(raster.at(x, y).data(), 3, row);
  }
  return image;
}

Raster pixels_of(vtkRenderWindow& window) {
  window.Render();
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(&window);
  filter->SetInputBufferTypeToRGB();
  filter->ReadFrontBufferOff();
  filter->Update();
  vtkImageData& image = *filter->GetOutput();
  const int* const size = image.GetDimensions();
  Raster raster(size[0], size[1], {});
  for (int y = 0; y < raster.height; ++y) {
    // VTK's first row is the lowest.
    const auto* row = static_cast<const unsigned char*>(image.GetScalarPointer(0, raster.height - 1 - y, 0));
    for (int x = 0; x < raster.width; ++x, row += 3) std::copy_n(row, 3, raster.at(x, y).begin());
  }
  return raster;
}

void write_png(const Raster& raster, const std::string& path) {
  vtkNew<vtkPNGWriter> writer;  // to memory: it would delete a file that it fails to write
  writer->WriteToMemoryOn();
  writer->SetInputData(image_of(raster));
  writer->Write();
  vtkUnsignedCharArray& png = *writer->GetResult();
  const auto size = static_cast<std::size_t>(png.GetNumberOfValues());
  write_file(path, {reinterpret_cast<const char*>(png.GetPointer(0)), size});
}

Raster draw_slide(PictureCanvas& canvas, const Stage& stage, std::size_t step, double width, bool is_fine) {
  const PixelBox scene = slide_scene_of(stage.steps.at(step));
  Picture sheet = slide_frame(stage, step, stage.title, scene);
  draw_legend(sheet, stage, step);
  return canvas.draw(sheet, {{&stage, step, scene}}, width / slide_width, is_fine);
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

std::string still_of(PictureCanvas& canvas, const Stage& stage, std::size_t step) {
  constexpr PixelBox frame{0, 0, 640, 640 / view_aspect};
  const Raster picture = canvas.draw({frame.width, frame.height}, {{&stage, step, frame}}, 1);
  return fmt::format("<img width=\"{}\" height=\"{}\" alt=\"{}\" src=\"data:image/jpeg;base64,{}\">",
                     picture.width, picture.height, escaped(stage.steps[step].caption), jpeg_of(picture));
}

Movie::Movie(const std::string& path, int rate) : path_(path), writer_(vtkOggTheoraWriter::New()) {
  writer_->SetFileName(path.c_str());
  writer_->SetRate(rate);
  writer_->SetQuality(2);
  writer_->SubsamplingOff();  // coloured letters stay sharp
}

Movie::~Movie() {
  if (is_begun_) writer_->End();
  writer_->Delete();
}

void Movie::add(const Raster& picture, int count) {
  writer_->SetInputData(image_of(picture));
  if (!is_begun_) writer_->Start();
  is_begun_ = true;
  for (int i = 0; i < count; ++i) writer_->Write();
  if (writer_->GetError() != 0) throw std::runtime_error("the film " + path_ + " can't be written");
}

}  // namespace rayproof::viz
