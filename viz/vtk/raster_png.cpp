#include "viz/vtk/raster_png.hpp"

#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

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
  const auto fail = [&path] { throw std::runtime_error("the file " + path + " can't be written"); };
  // VTK's writer only logs a failure: find out beforehand whether the file can be written.
  if (!std::ofstream(path, std::ios::binary)) fail();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image_of(raster));
  writer->Write();
  if (writer->GetErrorCode() != vtkErrorCode::NoError) fail();
}

}  // namespace rayproof::viz
