#include "viz/vtk/raster_png.hpp"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>

#include "case/files.hpp"

namespace rayproof::viz {

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

}  // namespace rayproof::viz
